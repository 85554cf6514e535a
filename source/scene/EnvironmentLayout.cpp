#include "source/scene/EnvironmentLayout.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "source/scene/lights/LightParts.h"

namespace ray {
namespace {

constexpr int fewest_rows = 128, most_rows = 8192;

std::string Number(int n) { return Words(static_cast<double>(n)); }

void CheckValues(const R2::Image& image) {
  const auto is_light = [](double channel) { return std::isfinite(channel) && channel >= 0; };
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) {
      const R2::Color c = image.At(x, y);
      if (is_light(c.r) && is_light(c.g) && is_light(c.b)) continue;
      throw std::invalid_argument("radiance must be finite and not negative, but pixel " + Number(x) + " " + Number(y) +
                                  " (from the left, from the bottom) is " + Words(c));
    }
}

/// Looks up a unit direction in a probe.
R2::Color InProbe(const R2::Image& image, const R3::Vector& d) {
  const double sine = std::sqrt(d.x * d.x + d.y * d.y), radius = R1::Atan2(sine, -d.z) / std::numbers::pi;
  // Straight back, every direction of the rim is correct.
  const double x = sine > 0 ? d.x / sine * radius : radius, y = sine > 0 ? d.y / sine * radius : 0;
  return image.At(Nearest((x + 1) / 2, image.Width()), Nearest((y + 1) / 2, image.Height()));
}

/// The position of a face of the cube in the image, counted in faces from the lower left, and its right and up
/// directions.
struct Face {
  int column, row;
  R3::Vector right, up;
};

Face FaceTowards(const R3::Vector& d, bool is_upright) {
  const int bottom = is_upright ? 1 : 0, middle = bottom + 1, top = bottom + 2;
  switch (MaxAxis(d)) {
    case 0:
      return d.x > 0 ? Face{2, middle, {0, 0, 1}, {0, 1, 0}} : Face{0, middle, {0, 0, -1}, {0, 1, 0}};
    case 1:
      return d.y > 0 ? Face{1, top, {1, 0, 0}, {0, 0, 1}} : Face{1, bottom, {1, 0, 0}, {0, 0, -1}};
    default:
      if (d.z < 0) return {1, middle, {1, 0, 0}, {0, 1, 0}};
      return is_upright ? Face{1, 0, {1, 0, 0}, {0, -1, 0}} : Face{3, middle, {-1, 0, 0}, {0, 1, 0}};
  }
}

R2::Color InCross(const R2::Image& image, const R3::Vector& d) {
  const bool is_upright = image.Width() < image.Height();
  const int size = is_upright ? image.Width() / 3 : image.Width() / 4;
  const Face face = FaceTowards(d, is_upright);
  const double distance = MaxComponent(Abs(d));
  return image.At(face.column * size + Nearest((Dot(d, face.right) / distance + 1) / 2, size),
                  face.row * size + Nearest((Dot(d, face.up) / distance + 1) / 2, size));
}

/// Returns the sine of latitude at a share of a row's height.
double SineOf(int row, double share, int rows) {
  const double low = SineOfEdge(row, rows), high = SineOfEdge(row + 1, rows);
  return low + share * (high - low);
}

/// Computes each texel as the mean over the centers of its four quarters of equal solid angle.
template <typename Lookup>
R2::Image Resampled(int rows, const Lookup& lookup) {
  constexpr double quarters[] = {0.25, 0.75};
  std::vector<R1::SineCosine> longitudes;  // two per column
  for (int x = 0; x < 2 * rows; ++x)
    for (const double share : quarters) longitudes.push_back(LongitudeOf(x, share, rows));
  R2::Image map(2 * rows, rows);
  for (int y = 0; y < rows; ++y) {
    const double latitudes[] = {SineOf(y, quarters[0], rows), SineOf(y, quarters[1], rows)};
    for (int x = 0; x < 2 * rows; ++x) {
      const R1::SineCosine* in_column = &longitudes[2 * static_cast<std::size_t>(x)];
      R2::Color sum;
      for (const double latitude : latitudes)
        for (int i = 0; i < 2; ++i) sum += lookup(Towards(latitude, in_column[i]));
      map.Set(x, y, sum / 4);
    }
  }
  return map;
}

}  // namespace

std::string_view Name(EnvironmentLayout layout) {
  switch (layout) {
    case EnvironmentLayout::latitude_longitude:
      return "latitude-longitude map";
    case EnvironmentLayout::angular_probe:
      return "angular probe";
    case EnvironmentLayout::cross:
      return "cross of six faces";
  }
  return "";
}

EnvironmentLayout LayoutOf(const R2::Image& image) {
  const std::int64_t width = image.Width(), height = image.Height();
  if (width > 0 && width == 2 * height) return EnvironmentLayout::latitude_longitude;
  if (width > 0 && width == height) return EnvironmentLayout::angular_probe;
  // Whole faces follow: 4 w = 3 h has integer solutions only in multiples of three and four.
  if (width > 0 && (4 * width == 3 * height || 3 * width == 4 * height)) return EnvironmentLayout::cross;
  throw std::invalid_argument(
      "an environment map must be 2:1 (latitude-longitude), 1:1 (angular probe), or 3:4 or 4:3 (cross of six cube "
      "faces), got " +
      Number(image.Width()) + " x " + Number(image.Height()));
}

R2::Image Unfolded(R2::Image image, EnvironmentLayout layout) {
  CheckValues(image);
  switch (layout) {
    case EnvironmentLayout::latitude_longitude:
      return image;
    case EnvironmentLayout::angular_probe:
      return Resampled(std::clamp(image.Height(), fewest_rows, most_rows),
                       [&](const R3::Vector& d) { return InProbe(image, d); });
    case EnvironmentLayout::cross:
      return Resampled(std::clamp(2 * std::min(image.Width(), image.Height()) / 3, fewest_rows, most_rows),
                       [&](const R3::Vector& d) { return InCross(image, d); });
  }
  return image;
}

}  // namespace ray
