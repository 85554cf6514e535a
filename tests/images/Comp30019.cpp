// COMP30019's own pictures, where the checkout has them beside it: bytes of the PNGs, pixels that differ at all. Pixels
// on edges are told apart by the last digits of a number, and the course's program has fewer of them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "R2/Image.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;

fs::path CourseFolder() { return project::Shared() / "scenes-comp30019"; }

#define NEEDS_THE_COURSE() \
  NEEDS_THE_PROGRAM();     \
  if (!fs::exists(CourseFolder())) GTEST_SKIP() << "the course's scenes are not beside this checkout"

struct ByteImage {
  int width = 0, height = 0;
  std::vector<std::array<int, 3>> pixels;
};

ByteImage BytesIn(const std::string& file) {
  const R2::Image image = Decode(file).image;
  ByteImage picture{image.Width(), image.Height(), {}};
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) {
      const R2::Color c = 255 * image.At(x, y);
      picture.pixels.push_back(
          {static_cast<int>(std::lround(c.r)), static_cast<int>(std::lround(c.g)), static_cast<int>(std::lround(c.b))});
    }
  return picture;
}

ByteImage Reference(const std::string& name) { return BytesIn((CourseFolder() / "reference" / name).string()); }

enum class Form { comp30019, raypro };

/// What the program makes of a scene of the course, with these words behind the names.
ByteImage Rendered(const std::string& scene, std::vector<std::string> words, Form form = Form::comp30019) {
  const TemporaryFolder folder;
  const std::string in = (CourseFolder() / "tests" / scene).string(), out = folder / "out.png";
  if (form == Form::raypro)
    words.insert(words.begin(), {in, out});
  else
    words.insert(words.begin(), {"-as", "comp30019", "-f", in, "-o", out});
  const Finished done = RunProgram(words);
  EXPECT_EQ(done.status, 0) << done.error;
  return done.status == 0 ? BytesIn(out) : ByteImage();
}

int Largest(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

int DifferentPixels(const ByteImage& a, const ByteImage& b) {
  EXPECT_EQ(a.pixels.size(), b.pixels.size());
  if (a.pixels.size() != b.pixels.size()) return -1;
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) count += a.pixels[i] != b.pixels[i];
  return count;
}

double MeanDifference(const ByteImage& a, const ByteImage& b) {
  EXPECT_EQ(a.pixels.size(), b.pixels.size());
  if (a.pixels.size() != b.pixels.size()) return 255;
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) sum += std::abs(a.pixels[i][k] - b.pixels[i][k]);
  return sum / (3 * static_cast<double>(a.pixels.size()));
}

TEST(Comp30019Pictures, Stage1IsTheCoursesToTheByte) {
  NEEDS_THE_COURSE();
  const ByteImage flat = Rendered("sample_scene_1.txt", {"-mode", "flat"}, Form::raypro);
  EXPECT_EQ(DifferentPixels(flat, Reference("sample_scene_1_s1.png")), 0);
}

// The one pixel is at the edge of the sphere's shadow, in column 35, row 331 from the top: from the floor there, the
// line to the light passes the sphere's center at .499976593, computed with 40 digits, and so is blocked by its radius
// of .5.
TEST(Comp30019Pictures, DiffuseScenesMatchTheCourseButForOneShadowPixel) {
  NEEDS_THE_COURSE();
  ByteImage ours = Rendered("sample_scene_1.txt", {});
  const ByteImage theirs = Reference("sample_scene_1_x1.png");
  ASSERT_EQ(ours.pixels.size(), theirs.pixels.size());
  constexpr std::size_t at_edge = (400 - 1 - 331) * 400 + 35;  // rows from the bottom
  EXPECT_EQ(ours.pixels[at_edge], (std::array{0, 0, 0}));
  ours.pixels[at_edge] = theirs.pixels[at_edge];
  EXPECT_EQ(DifferentPixels(ours, theirs), 0);
}

TEST(Comp30019Pictures, With16SamplesPerPixelAtMost18PixelsDiffer) {
  NEEDS_THE_COURSE();
  EXPECT_LE(DifferentPixels(Rendered("sample_scene_1.txt", {"-x", "4"}), Reference("sample_scene_1_s2.png")), 18);
}

TEST(Comp30019Pictures, TheCameraTurnsAsTheCoursesDoes) {
  NEEDS_THE_COURSE();
  const ByteImage down =
      Rendered("sample_scene_1.txt", {"--cam-pos", "0,2,-0.5", "--cam-axis", "1,0,0", "--cam-angle", "45"});
  EXPECT_LE(DifferentPixels(down, Reference("sample_scene_1_cam_pitch45.png")), 4);
  const ByteImage oblique =
      Rendered("sample_scene_1.txt", {"--cam-pos", "0,0,-1", "--cam-axis", "0,0.707,0.707", "--cam-angle", "20"});
  EXPECT_LE(DifferentPixels(oblique, Reference("sample_scene_1_cam_oblique20.png")), 4);
  const ByteImage up = Rendered("sample_scene_1.txt", {"--cam-axis", "1,0,0", "--cam-angle", "-45"});
  for (const auto& pixel : up.pixels) ASSERT_EQ(pixel, (std::array{0, 0, 0}));  // past everything
}

TEST(Comp30019Pictures, MirrorsAndGlassMatchTheCourseWithinATwentiethLevel) {
  NEEDS_THE_COURSE();
  EXPECT_LE(MeanDifference(Rendered("sample_scene_2.txt", {"-x", "3"}), Reference("sample_scene_2_x3.png")), 0.05);
  EXPECT_LE(MeanDifference(Rendered("sample_scene_2.txt", {"-x", "4"}), Reference("sample_scene_2_s2.png")), 0.05);
}

/// Whether a pixel shows the bunny and light falls on it: nothing else has red and blue alike and more than green.
bool IsLitBunny(const std::array<int, 3>& pixel) {
  return std::abs(pixel[0] - pixel[2]) <= 1 && pixel[0] > pixel[1] + 1;
}

// The course's solution does not make blended vertex normals unit again, which darkens the middle of triangles, mostly
// by a level or two; without that, 99 % of the pixels would be within 2 levels.
TEST(Comp30019Pictures, TheBunnyFacesAsItDoesInTheCourse) {
  NEEDS_THE_COURSE();
  const ByteImage ours = Rendered("sample_scene_obj.txt", {}), theirs = Reference("sample_scene_obj_x1.png");
  const ByteImage flat = Rendered("sample_scene_obj.txt", {"-mode", "flat"}, Form::raypro);
  ASSERT_EQ(ours.pixels.size(), theirs.pixels.size());
  constexpr std::array bunny_color{255, 127, 255};
  int lit_in_one = 0, lit_in_both = 0, of_bunny = 0, alike = 0;
  for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
    const bool a = IsLitBunny(ours.pixels[i]), b = IsLitBunny(theirs.pixels[i]),
               is_bunny = flat.pixels[i] == bunny_color;
    lit_in_one += a || b;
    lit_in_both += a && b;
    of_bunny += is_bunny;
    alike += is_bunny && Largest(ours.pixels[i], theirs.pixels[i]) <= 2;
  }
  EXPECT_GE(lit_in_both, 0.98 * lit_in_one);
  EXPECT_GE(std::lround(100.0 * alike / of_bunny), 86);
}

}  // namespace
}  // namespace ray::testing
