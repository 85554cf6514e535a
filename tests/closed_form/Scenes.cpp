// Scenes whose answer is known on paper. Each file says how in its first comment, and what to expect of the one pixel
// around the camera's axis; a new one is one more file.

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/Project.h"

namespace {

struct Expectation {
  ray::RenderSettings settings;
  R2::Color color;
  double tolerance = -1;
};

/// Lines such as "# max_depth 5" and "# expect 1 0.5 0 within 1e-12" at the top of a scene.
Expectation ReadExpectation(const std::filesystem::path& file) {
  Expectation e;
  e.settings.width = e.settings.height = 1;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line) && line.starts_with("#");) {
    std::istringstream words(line.substr(1));
    std::string word, within;
    words >> word;
    if (word == "max_depth") words >> e.settings.trace.max_depth;
    if (word == "min_luminance") words >> e.settings.trace.min_luminance;
    if (word == "shadow_samples") words >> e.settings.trace.shadow_samples;
    if (word == "expect") words >> e.color.r >> e.color.g >> e.color.b >> within >> e.tolerance;
  }
  return e;
}

TEST(ClosedForm, EverySceneGivesTheAnswerDerivedInItsFirstLines) {
  const auto files = project::Scenes(project::Root() / "tests" / "closed_form");
  ASSERT_GE(files.size(), 25u);
  for (const auto& file : files) {
    const Expectation expected = ReadExpectation(file);
    ASSERT_GE(expected.tolerance, 0) << file << " has no line '# expect r g b within tolerance'";
    const project::Stage stage(file);
    for (const auto* kind : ray::AcceleratorKinds()) {
      const R2::Color got = project::Render(stage, expected.settings, {kind->name}).image.At(0, 0);
      // A picture keeps floats: 24 bits of what was computed.
      const auto tolerance = [&](double x) { return expected.tolerance + std::abs(x) * 0x1p-24; };
      EXPECT_NEAR(got.r, expected.color.r, tolerance(expected.color.r)) << file << " with -accel " << kind->name;
      EXPECT_NEAR(got.g, expected.color.g, tolerance(expected.color.g)) << file << " with -accel " << kind->name;
      EXPECT_NEAR(got.b, expected.color.b, tolerance(expected.color.b)) << file << " with -accel " << kind->name;
    }
  }
}

}  // namespace
