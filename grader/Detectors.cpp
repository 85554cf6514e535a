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

/// A sentence about an image that is black or has one color.
std::optional<std::string> EmptyRemark(const R2::Image& image) {
  if (std::ranges::all_of(image.Channels(), [](float channel) { return channel < dark; }))
    return "The whole image is black. Does the camera look at the scene, and does a camera ray find a hit at t > 0?";
  if (IsOfOneColor(image))
    return "The whole image has one color. Is the color of each pixel stored, and are camera rays different?";
  return {};
}

/// Where single pixels differ amid others that do not, by what they are instead.
struct Specks {
  std::int64_t darker = 0, background = 0;
};

Specks SpecksOf(const Submission& student, const Comparison& found, const SceneImages& images) {
  Specks specks;
  const R2::Image& expected = images.Reference();
  const R2::Image& actual = student.image;
  const int width = actual.Width(), height = actual.Height();
  const auto differs = [&](int x, int y) { return found.differs[static_cast<std::size_t>(y * width + x)]; };
  const R2::Color background = expected.At(0, height - 1);
  for (int y = 1; y + 1 < height; ++y)
    for (int x = 1; x + 1 < width; ++x) {
      if (!differs(x, y)) continue;
      int around = 0;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) around += differs(x + i, y + j);
      if (around > 5) continue;
      if (Luminance(actual.At(x, y)) < 0.8 * Luminance(expected.At(x, y))) ++specks.darker;
      if (!IsDark(expected.At(x, y)) && LargestChannel(actual.At(x, y) - background) < dark) ++specks.background;
    }
  return specks;
}

/// A mistake of the table.
const Mistake* Named(std::string_view name) {
  return *std::ranges::find_if(Mistakes(), [&](const Mistake* mistake) { return mistake->name == name; });
}

std::string PercentOf(std::int64_t count, const Comparison& found) {
  return Rounded(100.0 * static_cast<double>(count) / static_cast<double>(std::max<std::int64_t>(1, found.steady)), 2) +
         "%";
}

/// A sentence about acne or cracks.
std::optional<std::string> SpeckRemark(const Submission& student, const Comparison& found, const SceneImages& images) {
  constexpr double share_of_specks = 0.002;  // of the steady pixels: 40 of an image of 160 x 120
  if (images.CellSide() > 1) return {};
  const Specks specks = SpecksOf(student, found, images);
  const auto least = static_cast<std::int64_t>(share_of_specks * static_cast<double>(found.steady));
  if (specks.background > least && 2 * specks.background > found.differing)
    return "Cracks: single pixels (" + PercentOf(specks.background, found) +
           ") show the background where a surface should be. A ray that meets an edge belongs to one of the two "
           "triangles; a test with < on both sides lets it through.";
  if (specks.darker > least && 2 * specks.darker > found.differing)
    return "Shadow acne: single pixels (" + PercentOf(specks.darker, found) +
           ") are too dark on lit, smooth surfaces. A shadow ray that starts on a surface meets it again by rounding; "
           "start it a little off the surface.";
  return {};
}

}  // namespace

// Mistakes come before specks: moved edges leave single dark pixels as well, and no mistake makes most of what acne
// does.
Verdict VerdictOn(const Submission& student, const Comparison& found, SceneImages& images) {
  if (const auto remark = EmptyRemark(student.image)) return {.kind = Verdict::Kind::empty, .remark = *remark};
  const Explanation explanation = Explain(student, images);
  if (!explanation.mistakes.empty()) return {.kind = Verdict::Kind::mistakes, .explanation = explanation};
  if (const auto remark = SpeckRemark(student, found, images))
    return {.kind = Verdict::Kind::specks, .remark = *remark};
  return {};
}

std::optional<std::string> TerminatorRemark(const Submission& student, const Comparison& found, SceneImages& images) {
  constexpr double most = 0.8;  // of what differs
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
  return "Shadow terminator: what differs (" + PercentOf(count, found) +
         ") lies where light grazes smooth meshes. There the blended normal faces the light though the triangle does "
         "not: a shadow ray is tested against the triangles as they are, its own included.";
}

}  // namespace ray::grade
