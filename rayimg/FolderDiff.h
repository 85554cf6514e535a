#pragma once

#include <string>
#include <vector>

#include "rayimg/PairResult.h"

namespace ray::rayimg {

/// Pairs images by name. An image without a partner by its whole name is paired by its name without the extension, if
/// there is exactly one on each side.
///   images, references   file names; sorted
///   returns              pairs, then the files without a partner
std::vector<Pair> PairsOf(const std::vector<std::string>& images, const std::vector<std::string>& references);

/// Compares the folders given in the options.
int DiffFolders(const ImageOptions& options);

}  // namespace ray::rayimg
