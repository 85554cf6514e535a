#pragma once

#include <optional>
#include <string>

#include "grader/Comparison.h"

namespace ray::grade {

bool IsBlack(const R2::Image& image);
/// Returns a sentence about an image that is black or has one color.
std::optional<std::string> EmptyRemark(const R2::Image& image);

/// Returns a sentence about cracks between triangles: single pixels that show the background.
std::optional<std::string> CrackRemark(const Submission& student, const Comparison& found, const SceneImages& images);

/// Returns a sentence about shadow terminators: the image differs where light grazes smooth meshes, so that the blended
/// normal faces it though the triangle does not.
std::optional<std::string> TerminatorRemark(const Submission& student, const Comparison& found, SceneImages& images);

}  // namespace ray::grade
