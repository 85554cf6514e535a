#include "source/parse/meshes/VertexColors.h"

#include <algorithm>

#include "source/parse/Coordinate.h"

namespace ray {
namespace {

constexpr float no_color = -1;  // until it is known what white is
constexpr std::array none{no_color, no_color, no_color};
constexpr double largest = 255;

}  // namespace

void VertexColors::Add(std::size_t place, const std::array<double, 3>& channels, const Token& where) {
  colors_.resize(place, none);
  const bool is_usable = std::ranges::all_of(channels, [](double c) { return c >= 0 && c <= largest; });
  if (!is_usable) {
    absent_.Add(where);
    return;
  }
  greatest_ = std::max(greatest_, *std::ranges::max_element(channels));
  colors_.push_back(
      {static_cast<float>(channels[0]), static_cast<float>(channels[1]), static_cast<float>(channels[2])});
}

std::vector<std::array<float, 3>> VertexColors::Take(std::size_t vertices) {
  if (colors_.empty()) return {};
  colors_.resize(vertices, none);
  for (auto& color : colors_) {
    if (color == none)
      color = {1, 1, 1};
    else if (WereBytes())
      for (float& channel : color) channel /= 255;
  }
  return std::move(colors_);
}

void VertexColors::Warn(const Text& file, Report& report) const {
  absent_.Warn(file, report, "color of a vertex is not finite or negative and counts as white",
               "colors of vertices are not finite or negative and count as white");
}

}  // namespace ray
