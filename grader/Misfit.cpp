#include "grader/Misfit.h"

#include <algorithm>
#include <cmath>

namespace ray::grade {
namespace {

std::size_t CellIndex(const R2::Image& image, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.Width()) + static_cast<std::size_t>(x);
}

double SquareBeyond(double channel, double allowed) {
  const double beyond = std::abs(channel) - allowed;
  return beyond > 0 ? beyond * beyond : 0;
}

/// Returns true if this place is shading, not an edge, in the image with a mistake.
bool IsCalm(const R2::Image& cells, const R2::Image& reference, int x, int y) {
  constexpr double calm = 0.08;  // four of the usual tolerances: shading changes less between adjacent pixels
  const R2::Color c = cells.At(x, y);
  if (LargestChannel(c - reference.At(x, y)) < calm) return true;
  for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
    const int i = std::clamp(x + dx, 0, cells.Width() - 1), j = std::clamp(y + dy, 0, cells.Height() - 1);
    if (LargestChannel(cells.At(i, j) - c) > calm) return false;
  }
  return true;
}

/// Returns the distance of a color from the range of colors at a pixel and its four neighbors.
R2::Color BeyondNeighbors(const R2::Image& cells, int x, int y, const R2::Color& color) {
  R2::Color low = cells.At(x, y), high = low;
  for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
    const R2::Color c =
        cells.At(std::clamp(x + dx, 0, cells.Width() - 1), std::clamp(y + dy, 0, cells.Height() - 1));
    low = {std::min(low.r, c.r), std::min(low.g, c.g), std::min(low.b, c.b)};
    high = {std::max(high.r, c.r), std::max(high.g, c.g), std::max(high.b, c.b)};
  }
  const auto beyond = [](double value, double from, double to) { return value - std::clamp(value, from, to); };
  return {beyond(color.r, low.r, high.r), beyond(color.g, low.g, high.g), beyond(color.b, low.b, high.b)};
}

/// The difference of the student's image from another at a cell.
enum class Cell : unsigned char { ignored, same, darker, other };

/// Counts for the statistics of acne: a wrong shadow changes between lit and dark at few pairs of neighbors, acne at
/// many, along both axes.
struct Texture {
  double counted = 0, darker = 0, other = 0, turns_across = 0, turns_along = 0;

  bool IsAcne() const {
    constexpr double least_share = 0.002, mostly = 0.8;  // of the counted pixels; of the differing ones
    // Independent specks of density p change 2 p (1 - p) times per pixel; a dark region of width w changes 2 / w times
    // along each of its rows. 0.15 is between those of regions of 7 pixels, and of specks that fill 5 of 6 pixels.
    constexpr double ragged = 0.15;
    return darker > least_share * counted && darker > mostly * (darker + other) &&
           std::min(turns_across, turns_along) > 2 * ragged * darker;
  }
};

Texture TextureOf(const std::vector<Cell>& cells, int width, int height) {
  Texture texture;
  const auto at = [&](int x, int y) { return cells[static_cast<std::size_t>(y * width + x)]; };
  const auto turns = [](Cell a, Cell b) {
    return a != Cell::ignored && b != Cell::ignored && (a == Cell::darker) != (b == Cell::darker);
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Cell cell = at(x, y);
      texture.counted += cell != Cell::ignored;
      texture.darker += cell == Cell::darker;
      texture.other += cell == Cell::other;
      if (x > 0) texture.turns_across += turns(at(x - 1, y), cell);
      if (y > 0) texture.turns_along += turns(at(x, y - 1), cell);
    }
  return texture;
}

}  // namespace

Exhibit MakeExhibit(SceneImages& images, Submission student) {
  Exhibit exhibit{&images, std::move(student), {}, false};
  exhibit.found = Compare(exhibit.student, images);
  exhibit.is_right = exhibit.found.Percent() <= images.scene().allowed;
  return exhibit;
}

std::optional<Fit> FitOf(const Exhibit& exhibit, const R2::Image& image, const std::vector<double>* own_spread) {
  constexpr double rounding = 1.5 / 255;
  // of the steady pixels: fewer would not represent the others
  constexpr double enough = 0.4;
  const SceneImages& images = *exhibit.images;
  const Submission& student = exhibit.student;
  const R2::Image cells = images.Cells(image), reference = images.Cells(images.Reference());
  const int width = cells.Width(), height = cells.Height();
  const bool has_pixels = images.CellSide() == 1;
  std::vector<Cell> kinds(student.tolerance.size(), Cell::ignored);
  std::vector<double> squares(student.tolerance.size(), 0.0);
  double steady = 0, calm = 0;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::size_t i = CellIndex(cells, x, y);
      if (has_pixels && !images.Steady()[i]) continue;
      ++steady;
      const double spread = has_pixels && own_spread ? (*own_spread)[i] : 0;
      const bool is_calm =
          spread <= images.scene().tolerance && (!has_pixels || own_spread || IsCalm(cells, reference, x, y));
      calm += is_calm;
      const R2::Color color = student.cells.At(x, y);
      const R2::Color d = is_calm || own_spread ? color - cells.At(x, y) : BeyondNeighbors(cells, x, y, color);
      const double tolerance = student.tolerance[i] + spread, allowed = rounding + tolerance - images.scene().tolerance;
      squares[i] = SquareBeyond(d.r, allowed) + SquareBeyond(d.g, allowed) + SquareBeyond(d.b, allowed);
      const bool differs = LargestChannel(d) > tolerance;
      kinds[i] = !differs ? Cell::same : Luminance(d) < 0 ? Cell::darker : Cell::other;
    }
  if (!(calm > enough * steady)) return {};
  const Texture texture = TextureOf(kinds, width, height);
  const bool has_acne = has_pixels && texture.IsAcne();
  Fit fit;
  double differing = texture.other + (has_acne ? 0 : texture.darker);
  for (std::size_t i = 0; i < squares.size(); ++i)
    if (!(has_acne && kinds[i] == Cell::darker)) fit.squares += squares[i];
  fit.percent = 100 * differing / steady;
  fit.specks = has_acne ? 100 * texture.darker / steady : 0;
  return fit;
}

}  // namespace ray::grade
