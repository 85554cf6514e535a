// The smallest tracer, tiny/, and the room of bench/fastest, against raypro.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "R2/ImageFile.h"
#include "source/parse/Parse.h"
#include "source/render/Render.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace {

using Bytes = std::vector<unsigned char>;

/// What a command writes to the file that is named behind it.
Bytes OutputOf(const std::string& command) {
  const ray::testing::TemporaryFolder folder;
  const std::string file = folder / "out.ppm";
  EXPECT_EQ(std::system((command + " '" + file + "'").c_str()), 0) << command;
  const std::string bytes = ray::testing::ReadFile(file);
  return {bytes.begin(), bytes.end()};
}

Bytes PpmOfRaypro(const std::string& scene) {
  const char* const program = std::getenv("RAYPRO");
  if (!program) return {};
  return OutputOf("'" + std::string(program) + "' '" + (project::Root() / scene).string() +
                  "' -quiet -width 512 -height 512");
}

struct Differences {
  int by_one = 0, by_more = 0;  // pixels, by the largest of their channels, in levels
};

Differences Compare(const Bytes& a, const Bytes& b) {
  constexpr std::size_t header = 15;
  Differences differences;
  for (std::size_t i = header; i + 2 < a.size(); i += 3) {
    int most = 0;
    for (std::size_t k = i; k < i + 3; ++k) most = std::max(most, std::abs(a[k] - b[k]));
    differences.by_one += most == 1, differences.by_more += most > 1;
  }
  return differences;
}

/// Rounding decides where rays meet an edge: of a tile, a shadow or a ball.
void ExpectImageOfRaypro(const char* name, int most_by_one, int most_by_more) {
  const char* const folder = std::getenv("TINY");
  const auto program = std::filesystem::path(folder ? folder : "") / name;
  if (!folder || !std::filesystem::exists(program)) GTEST_SKIP() << "not built here: make tiny";
  const Bytes expected = PpmOfRaypro("scenes/tiny.scn");
  const Bytes found = OutputOf("'" + program.string() + "' >");
  ASSERT_EQ(found.size(), std::size_t{15 + 512 * 512 * 3});
  ASSERT_EQ(found.size(), expected.size());
  const Differences differences = Compare(found, expected);
  EXPECT_LE(differences.by_one, most_by_one);
  EXPECT_LE(differences.by_more, most_by_more);
}

TEST(Tiny, ItsSourceDrawsTheImageThatRayproDraws) { ExpectImageOfRaypro("tiny", 5, 20); }

// In single precision one pixel in 500 is rounded to the neighboring level.
TEST(Tiny, ItsExecutableDrawsItInSinglePrecision) { ExpectImageOfRaypro("small", 1000, 25); }

TEST(Room, FramesInProcessAreTheBytesOfRaypro) {
  const Bytes expected = PpmOfRaypro("scenes/room.scn");
  if (expected.empty()) GTEST_SKIP() << "RAYPRO is not set";
  const ray::ParsedScene parsed = ray::Parse((project::Root() / "scenes/room.scn").string(), {});
  const ray::World world(parsed.scene);
  const ray::AcceleratorSettings how;
  const auto accelerator = ray::FindAcceleratorKind(how.name)->Make(world, how);
  ray::RenderSettings settings = project::Sized(512);
  settings.threads = 2;
  settings.view = parsed.scene.camera;
  const R2::Image image = ray::Render(world, *accelerator, settings).image;
  EXPECT_TRUE(R2::FormatForName("frame.ppm")->encode(image, {}, {}) == expected);
}

}  // namespace
