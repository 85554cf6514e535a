#include "source/view/overlay/SliceView.h"

#include <algorithm>
#include <cmath>

#include "R1/Elementary.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr double room_around = 1.05;  // of what is cut, so that its outline does not touch the edge
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

  /// With digits enough to tell each from the next.
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

/// Nothing where there is no room for it to the right of `numbers_end`, a column of the drawing.
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

}  // namespace ray
