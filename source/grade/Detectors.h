#pragma once

#include <string>
#include <vector>

#include "source/grade/Comparison.h"

namespace ray::grade {

/// What an image shows that no mistake of the table makes: black, of one color, acne, cracks. Sentences for the
/// student.
std::vector<std::string> RemarksOn(const Submission& student, const Comparison& found, const SceneImages& images);

}  // namespace ray::grade
