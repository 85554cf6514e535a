#pragma once

#include <string>
#include <vector>

#include "source/rayimg/PairResult.h"

namespace ray::rayimg {

/// Images of one name; where an image has no partner of its whole name, the one of its name without the extension, if
/// there is just one on each side.
///   pictures, references   names of files; sorted
///   returns                pairs, then those without a partner
std::vector<Pair> PairsOf(const std::vector<std::string>& pictures, const std::vector<std::string>& references);

/// Compares the folders that the options name.
int DiffFolders(const ImageOptions& options);

}  // namespace ray::rayimg
