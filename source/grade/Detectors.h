#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/grade/Comparison.h"

namespace ray::grade {

/// What an image shows that no mistake of the table makes: black, of one color, acne, cracks. Sentences for the
/// student.
std::vector<std::string> RemarksOn(const Submission& student, const Comparison& found, const SceneImages& images);

/// Where no mistake of the table explains the image: whether it differs along the shadow terminators of smooth meshes,
/// where light grazes and the blended normal faces it though the triangle does not. A sentence for the student.
std::optional<std::string> TerminatorRemark(const Submission& student, const Comparison& found, SceneImages& images);

}  // namespace ray::grade
