#include "source/inspect/SliceView.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "R1/Elementary.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr double room_around = 1.05;  // times the size of the cut, so that its outline does not touch the edge
constexpr Rgba grid_color{255, 255, 255, 28}, zero_color{255, 255, 255, 80}, scale_color{255, 255, 255, 255};
constexpr Rgba number_color{210, 210, 220, 255};
constexpr double gap = 0.25;               // between text and an edge, in heights of a line
constexpr double columns_of_a_number = 9;  // letters from one number to the next: "-12.345" and a space each side
constexpr double rows_of_a_number = 3;

/// Numbers of one axis.
struct Ticks {
  double step = 0;
  std::vector<double> at;
  int power = 0;  // numbers are shown in units of 10 to it, which the name of the axis says

  /// Returns the number with enough digits to distinguish each from the next.
  std::string Text(double value) const {
    constexpr double most_decimals = 15;  // of a double near 1
    const double unit = R1::Pow(10, power), decimals = -std::floor(R1::Log10(step / unit) + rounding);
    return Fixed(value / unit, static_cast<int>(std::clamp(decimals, 0.0, most_decimals)));
  }
  /// "x", or "x, 10^6" where numbers are in millions.
  std::string Name(const std::string& name) const { return power == 0 ? name : name + ", 10^" + std::to_string(power); }

 private:
  static constexpr double rounding = 1e-9;  // of a step's logarithm
};

/// Numbers from 1e-6 to below 1e9 are short enough in full.
int PowerFor(double tick_step, double largest) {
  constexpr double least_step = 1e-6, most = 1e9;
  if (tick_step >= least_step && largest < most) return 0;
  return 3 * static_cast<int>(std::floor(R1::Log10(largest) / 3));
}

Ticks TicksOf(double low, double high, double room_for) {
  Ticks ticks;
  const int most = static_cast<int>(std::min(room_for, 100.0));
  if (most < 1 || !(high > low)) return ticks;
  ticks.step = TickStep(high - low, most);
  const double first = std::ceil(low / ticks.step);
  // Counted, since far from 0 adding 1 may not change a number.
  for (int i = 0; i <= most; ++i) {
    const double value = (first + i) * ticks.step + 0.0;  // which is never -0
    if (value <= high) ticks.at.push_back(value);
  }
  if (!ticks.at.empty())
    ticks.power = PowerFor(ticks.step, std::max({std::abs(ticks.at.front()), std::abs(ticks.at.back()), ticks.step}));
  return ticks;
}

/// Adds the scale if there is room for it to the right of `numbers_end`, a column of the drawing.
void AddScale(SliceAxes& axes, const SliceView& view, const Ticks& ticks, const LetterSize& letters,
              double numbers_end) {
  const double letter = letters.width, line = letters.height, edge = gap * line;
  const std::string text = ticks.Text(ticks.step) + (ticks.power == 0 ? "" : " 10^" + std::to_string(ticks.power));
  const double right = view.size.width - edge, left = right - ticks.step / view.pixel, y = 2 * line;
  const double wide = letter * static_cast<double>(text.size());
  const double text_left = std::min((left + right - wide) / 2, right - wide);
  if (std::min(left, text_left) < numbers_end + letter) return;
  const auto at = [&](double x, double height) { return view.At(view.InSlice({x, height})); };
  AddLine(axes.lines, at(left, y), at(right, y), scale_color);
  for (const double x : {left, right}) AddLine(axes.lines, at(x, y - edge), at(x, y + edge), scale_color);
  axes.labels.push_back({text_left, y + edge, text, scale_color});
}

}  // namespace

SliceView SliceView::Of(const Slice& slice, const R3::Box& scene, const DrawingSize& size) {
  SliceView view;
  view.size = {std::max(1, size.width), std::max(1, size.height)};
  R2::Point low{-slice.extent, -slice.extent}, high{slice.extent, slice.extent};
  if (!scene.IsEmpty()) {
    low = high = slice.Project(scene.Corner(0));
    for (int i = 1; i < 8; ++i) {
      const R2::Point p = slice.Project(scene.Corner(i));
      low = {std::min(low.x, p.x), std::min(low.y, p.y)}, high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  view.middle = {(low.x + high.x) / 2, (low.y + high.y) / 2};
  const double needed = std::max((high.x - low.x) / view.size.width, (high.y - low.y) / view.size.height);
  view.pixel = needed > 0 ? room_around * needed : 2 * slice.extent / std::max(view.size.width, view.size.height);
  return view;
}

double TickStep(double range, int most) {
  double power = R1::Pow(10, std::floor(R1::Log10(range / most)) - 1);
  for (;; power *= 10)
    for (const double digit : {1.0, 2.0, 5.0})
      if (!(range / (digit * power) > most)) return digit * power;
}

SliceAxes AxesOf(const SliceView& view, const SliceCoordinates& coordinates, const LetterSize& letters) {
  SliceAxes axes;
  const double letter = letters.width, line = letters.height, edge = gap * line;
  const R2::Point low = view.InSlice({0, 0}),
                  high = view.InSlice(R2::Point{double(view.size.width), double(view.size.height)});
  const R2::Point& origin = coordinates.origin;
  const Ticks across = TicksOf(low.x - origin.x, high.x - origin.x, view.size.width / (columns_of_a_number * letter));
  const std::string right_name = across.Name(coordinates.names[0]);
  const double right_end = view.size.width - edge - letter * static_cast<double>(right_name.size());
  double free_from = 0;  // numbers far from 0 are long
  for (const double x : across.at) {
    const R2::Point foot{x + origin.x, low.y};
    AddLine(axes.lines, view.At(foot), view.At({foot.x, high.y}), x == 0 ? zero_color : grid_color);
    const std::string text = across.Text(x);
    const double wide = letter * static_cast<double>(text.size()), left = view.Pixel(foot).x - wide / 2;
    if (left < free_from || left + wide + letter > right_end) continue;
    axes.labels.push_back({left, edge, text, number_color});
    free_from = left + wide + letter;
  }
  const Ticks upward = TicksOf(low.y - origin.y, high.y - origin.y, view.size.height / (rows_of_a_number * line));
  double numbers_end = 0;
  for (const double y : upward.at) {
    const R2::Point foot{low.x, y + origin.y};
    AddLine(axes.lines, view.At(foot), view.At({high.x, foot.y}), y == 0 ? zero_color : grid_color);
    const double bottom = view.Pixel(foot).y - line / 2;
    // Above the numbers of the other axis, and below the name of this one.
    if (bottom < edge + line || bottom + 2 * line + edge > view.size.height) continue;
    const std::string text = upward.Text(y);
    axes.labels.push_back({edge, bottom, text, number_color});
    numbers_end = std::max(numbers_end, edge + letter * static_cast<double>(text.size()));
  }
  if (across.at.empty() || upward.at.empty()) return axes;
  axes.labels.push_back({right_end, edge, right_name, scale_color});
  axes.labels.push_back({edge, view.size.height - line - edge, upward.Name(coordinates.names[1]), scale_color});
  AddScale(axes, view, across, letters, numbers_end);
  return axes;
}

namespace {

constexpr double alpha_of_filling = 80 / 255.0;  // so that enclosed shapes are seen through it

Rgba ColorOfCut(const World& world, std::uint32_t instance) {
  const Material& m = *world.Instances()[instance].material;
  const R2::Color color = m.emission + m.kd + m.kr + m.kt;
  const double most = std::max({color.r, color.g, color.b});
  return most > 0 && std::isfinite(most) ? Shown(0.35 * R2::Color{1, 1, 1} + 0.65 / most * color)
                                         : Rgba{128, 128, 128, 255};
}

/// A crossing of an instance's outline with the middle of a row of pixels.
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

/// Returns the alpha of each of `layers` layers that together have the alpha of the filling.
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
