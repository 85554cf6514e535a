#pragma once

#include "grader/raygrade/Options.h"

namespace ray::raygrade {

/// Executes the options: grades a student or a class, tries all mistakes, or prints a new suite. Returns an exit
/// status; throws UsageError, SceneErrors and OutputError.
int Grade(const GradeOptions& options);

}  // namespace ray::raygrade
