#pragma once

#include "grader/SceneImages.h"

namespace ray::raygrade {

/// Reads a scene with its own settings and those that the suite gives as options of raypro. Throws SceneErrors, also
/// for wrong options, with their place in the suite.
grade::SceneToRender LoadScene(const grade::SuiteScene& scene, const std::string& file);

}  // namespace ray::raygrade
