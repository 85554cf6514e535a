#include "grader/Detectors.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "source/text/NumberText.h"

namespace ray::grade {
namespace {

constexpr double dark = 2.0 / 255;

bool IsDark(const R2::Color& c) { return std::max({c.r, c.g, c.b}) < dark; }

bool IsOfOneColor(const R2::Image& image) {
  const auto& channels = image.Channels();
  for (std::size_t i = 3; i < channels.size(); ++i)
    if (std::abs(channels[i] - channels[i - 3]) > 0.5F / 255) return false;
  return true;
}

/// Returns the number of single pixels that show the background instead of a surface.
std::int64_t BackgroundSpecks(const Submission& student, const Comparison& found, const SceneImages& images) {
  std::int64_t count = 0;
  const R2::Image& expected = images.Reference();
  const int width = expected.Width(), height = expected.Height();
  const auto differs = [&](int x, int y) { return found.differs[static_cast<std::size_t>(y * width + x)]; };
  const R2::Color background = expected.At(0, height - 1);
  for (int y = 1; y + 1 < height; ++y)
    for (int x = 1; x + 1 < width; ++x) {
      if (!differs(x, y)) continue;
      int around = 0;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) around += differs(x + i, y + j);
      constexpr int amid_others = 5;  // of nine
      count += around <= amid_others && !IsDark(expected.At(x, y)) &&
               LargestChannel(student.image.At(x, y) - background) < dark;
    }
  return count;
}

/// Returns a mistake of the table by its name.
const Mistake* Named(std::string_view name) {
  return *std::ranges::find_if(Mistakes(), [&](const Mistake* mistake) { return mistake->name == name; });
}

std::string PercentOf(std::int64_t count, const Comparison& found) {
  return Plain(100.0 * static_cast<double>(count) / static_cast<double>(std::max<std::int64_t>(1, found.steady)), 2) +
         "%";
}

}  // namespace

bool IsBlack(const R2::Image& image) {
  return std::ranges::all_of(image.Channels(), [](float channel) { return channel < dark; });
}

std::optional<std::string> EmptyRemark(const R2::Image& image) {
  if (IsBlack(image))
    return "The whole image is black. Does the camera look at the scene, and does a camera ray find a hit at t > 0?";
  if (IsOfOneColor(image))
    return "The whole image has one color. Is the color of each pixel stored, and are camera rays different?";
  return {};
}

std::optional<std::string> CrackRemark(const Submission& student, const Comparison& found, const SceneImages& images) {
  constexpr double share_of_specks = 0.002;  // of the steady pixels: 40 in an image of 160 x 120
  if (images.CellSide() > 1) return {};
  const std::int64_t count = BackgroundSpecks(student, found, images);
  const auto least = static_cast<std::int64_t>(share_of_specks * static_cast<double>(found.steady));
  if (count <= least || 2 * count <= found.differing) return {};
  return "Cracks: single pixels (" + PercentOf(count, found) +
         ") show the background where a surface should be. A ray that meets an edge belongs to one of the two "
         "triangles; a test with < on both sides lets it through.";
}

std::optional<std::string> TerminatorRemark(const Submission& student, const Comparison& found, SceneImages& images) {
  constexpr double most = 0.8;  // of the differing pixels
  const auto flat = images.With({Named("flat_shading")}), open = images.With({Named("no_shadows")}),
             closed = images.With({Named("no_diffuse"), Named("no_highlight")});
  if (images.CellSide() > 1 || !flat || !open || !closed) return {};
  const R2::Image& expected = images.Reference();
  std::int64_t count = 0;
  for (int y = 0; y < expected.Height(); ++y)
    for (int x = 0; x < expected.Width(); ++x) {
      const std::size_t i = static_cast<std::size_t>(y * expected.Width() + x);
      const auto differ = [&](const R2::Image& a, const R2::Image& b) {
        return LargestChannel(a.At(x, y) - b.At(x, y)) > student.tolerance[i];
      };
      const bool is_smooth = differ(*flat, expected);
      const bool is_of_shadow = !differ(student.image, *closed) || !differ(student.image, *open);
      count += found.differs[i] && is_smooth && is_of_shadow;
    }
  if (!(static_cast<double>(count) > most * static_cast<double>(found.differing))) return {};
  return "Shadow terminator: the differing pixels (" + PercentOf(count, found) +
         ") are where light grazes smooth meshes. There the blended normal faces the light though the triangle does "
         "not: a shadow ray is tested against the triangles as they are, its own included.";
}

}  // namespace ray::grade
