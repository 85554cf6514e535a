#pragma once

#include <limits>
#include <string>
#include <vector>

#include "R2/ImageFile.h"
#include "source/app/options/Program.h"
#include "tests/R2/Filled.h"
#include "tests/source/app/Program.h"

/// Runs rayimg on images made for the test.
namespace ray::rayimg {

using R2::Filled;
using testing::Decode;
using testing::Finished;
using testing::Has;
using testing::nothing;
using testing::ReadFile;
using testing::TemporaryFolder;
using testing::WriteFile;
using Words = std::vector<std::string>;

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline const Program& program = Program::rayimg;

inline Finished Rayimg(const Words& words) { return testing::RunProgram(words, {.program = "RAYIMG"}); }

/// Writes an image in the format of its name, and returns the name.
inline std::string Save(const std::string& file, const R2::Image& image, const R2::ImageSettings& settings = {}) {
  const auto bytes = R2::FormatForName(file)->encode(image, {}, settings);
  return WriteFile(file, {bytes.begin(), bytes.end()});
}

/// The only float format that keeps settings may be missing from this build.
inline bool HasExr() { return R2::FormatForName("a.exr") != nullptr; }

}  // namespace ray::rayimg
