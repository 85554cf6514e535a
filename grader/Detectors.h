#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/Comparison.h"

namespace ray::grade {

/// What is said of an image that differs: mistakes of the table, or what the image shows that none of them makes.
struct Verdict {
  enum class Kind { mistakes, empty, specks, unknown };
  Kind kind = Kind::unknown;
  Explanation explanation{};  // of mistakes
  std::string remark{};       // a sentence for the student: black or of one color; acne or cracks
};
Verdict VerdictOn(const Submission& student, const Comparison& found, SceneImages& images);

/// Where no mistake of the table explains the image: whether it differs along the shadow terminators of smooth meshes,
/// where light grazes and the blended normal faces it though the triangle does not. A sentence for the student.
std::optional<std::string> TerminatorRemark(const Submission& student, const Comparison& found, SceneImages& images);

}  // namespace ray::grade
