#include "source/view/overlay/CutDrawing.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "R1/Elementary.h"

namespace ray {
namespace {

constexpr double alpha_of_filling = 80 / 255.0;  // so that what is inside something else is seen through it

Rgba ColorOfCut(const World& world, std::uint32_t instance) {
  const Material& m = *world.Instances()[instance].material;
  const R2::Color color = m.emission + m.kd + m.kr + m.kt;
  const double most = std::max({color.r, color.g, color.b});
  return most > 0 && std::isfinite(most) ? Shown(0.35 * R2::Color{1, 1, 1} + 0.65 / most * color)
                                         : Rgba{128, 128, 128, 255};
}

/// Where the outline of one instance meets the middle of a row of pixels.
struct RowCrossing {
  int row;
  double x;  // in the slice's coordinates
  bool enters;

  friend bool operator<(const RowCrossing& a, const RowCrossing& b) {
    return a.row != b.row ? a.row < b.row : a.x < b.x;
  }
};

/// The outline of one instance.
struct Outline {
  std::vector<RowCrossing> crossings;
  std::map<std::uint32_t, int> ends;  // how many pieces end at each crossing of the cut

  bool IsClosed() const {
    return std::ranges::all_of(ends, [](const auto& end) { return end.second == 2; });
  }
};

/// `normal`: outward, at an angle below 90 degrees to that of the line.
void AddRows(Outline& outline, const SliceView& view, const R2::Point& a, const R2::Point& b,
             const R2::Vector& normal) {
  const R2::Vector way = b - a;
  // The line's own normal, on the side of `normal`.
  const double side = way.y * normal.x - way.x * normal.y;
  const bool enters = side < 0 ? way.y > 0 : way.y < 0;
  const auto first_row = [&](double y) {
    return static_cast<int>(std::clamp(std::ceil(view.Pixel({0, y}).y - 0.5), 0.0, double(view.size.height)));
  };
  // A row at an end belongs to the line above alone.
  for (int row = first_row(std::min(a.y, b.y)); row < first_row(std::max(a.y, b.y)); ++row) {
    const double y = view.InSlice({0, row + 0.5}).y;
    outline.crossings.push_back({row, a.x + (y - a.y) / way.y * way.x, enters});
  }
}

/// What so many layers have each that have the alpha of the filling together.
std::uint8_t AlphaOfLayer(int layers) {
  return static_cast<std::uint8_t>(std::lround(255 * (1 - R1::Pow(1 - alpha_of_filling, 1.0 / layers))));
}

void AddSpans(Lines& lines, Outline& outline, const SliceView& view, const Rgba& color) {
  std::sort(outline.crossings.begin(), outline.crossings.end());
  int depth = 0;
  const RowCrossing* start = nullptr;
  for (const RowCrossing& c : outline.crossings) {
    if (start && c.row != start->row) depth = 0;
    if (c.enters) {
      if (depth++ == 0) start = &c;
    } else if (depth > 0 && --depth == 0) {
      const double y = view.InSlice({0, c.row + 0.5}).y;
      AddLine(lines, view.At({start->x, y}), view.At({c.x, y}), color);
    }
  }
}

}  // namespace

Lines CutLines(const SceneCut& cut, const World& world, const SliceView& view) {
  Lines lines;
  for (const CutPiece& piece : cut.pieces) {
    const Crossing &from = cut.crossings[piece.from], &to = cut.crossings[piece.to];
    const Rgba shown = ColorOfCut(world, from.instance);
    const R2::Point corner = piece.corner.value_or(to.on_slice);
    AddLine(lines, view.At(from.on_slice), view.At(corner), shown);
    if (piece.corner) AddLine(lines, view.At(corner), view.At(to.on_slice), shown);
  }
  return lines;
}

Lines CutFilling(const SceneCut& cut, const World& world, const SliceView& view, int line_width) {
  std::map<std::uint32_t, Outline> outlines;  // by instance
  for (const Crossing& c : cut.crossings)
    outlines[c.instance].ends[static_cast<std::uint32_t>(&c - cut.crossings.data())];
  for (const CutPiece& piece : cut.pieces) {
    const Crossing &from = cut.crossings[piece.from], &to = cut.crossings[piece.to];
    Outline& outline = outlines[from.instance];
    ++outline.ends[piece.from], ++outline.ends[piece.to];
    if (piece.corner) {
      AddRows(outline, view, from.on_slice, *piece.corner, from.normal);
      AddRows(outline, view, *piece.corner, to.on_slice, to.normal);
    } else {
      AddRows(outline, view, from.on_slice, to.on_slice, {from.normal.x + to.normal.x, from.normal.y + to.normal.y});
    }
  }
  Lines lines;
  for (auto& [instance, outline] : outlines) {
    if (!world.Instances()[instance].shape->IsSolid() && !outline.IsClosed()) continue;
    Rgba color = ColorOfCut(world, instance);
    color[3] = AlphaOfLayer(line_width);
    AddSpans(lines, outline, view, color);
  }
  return lines;
}

}  // namespace ray
