#include "source/parse/meshes/VertexColors.h"

#include <algorithm>
#include <cmath>

#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr float no_color = -1;  // until the value of white is known
constexpr std::array none{no_color, no_color, no_color};
constexpr double largest = 255;
// Rounding and overexposure also exceed 1. A mesh whose brightest channel is below this value out of 255 is nearly
// black.
constexpr double surely_bytes = 16;
constexpr double half_a_step = 0.5 / largest;  // of a byte: a smaller excess above 1 is rounding

bool IsWhole(const std::array<float, 3>& color) {
  return std::ranges::all_of(color, [](float c) { return c == std::floor(c); });
}

}  // namespace

void VertexColors::Add(std::size_t place, const std::array<double, 3>& channels, const Token& where) {
  if (place >= colors_.size()) colors_.resize(place + 1, none);
  const bool is_usable = std::ranges::all_of(channels, [](double c) { return c >= 0 && c <= largest + 0.5; });
  if (!is_usable) {
    absent_.Add(where);
    return;
  }
  greatest_ = std::max(greatest_, *std::ranges::max_element(channels));
  for (std::size_t i = 0; i < channels.size(); ++i)
    colors_[place][i] = static_cast<float>(std::min(channels[i], largest));
}

std::vector<std::array<float, 3>> VertexColors::Take(std::size_t vertices) {
  if (colors_.empty()) return {};
  colors_.resize(vertices, none);
  were_bytes_ = greatest_ > 1 && (greatest_ >= surely_bytes || std::ranges::all_of(colors_, IsWhole));
  for (auto& color : colors_) {
    if (color == none)
      color = {1, 1, 1};
    else if (were_bytes_)
      for (float& channel : color) channel /= 255;
    else if (greatest_ > 1)
      for (float& channel : color) channel = std::min(channel, 1.0f);
  }
  return std::move(colors_);
}

void VertexColors::Warn(const Text& file, Report& report) const {
  absent_.Warn(file, report, "color of a vertex is not finite or negative and is replaced by white",
               "colors of vertices are not finite or negative and are replaced by white");
  if (!were_bytes_ && greatest_ > 1 + half_a_step)
    report.Warn(Escaped(file.name), "colors of vertices go up to " + ToText(greatest_) + "; above 1 they count as 1");
}

}  // namespace ray
