#include "source/draw/preview/DiffuseLight.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "R1/Elementary.h"

namespace ray {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int columns_of_diffuse = 256;  // as much as a polynomial of the second degree can tell, several times

std::array<double, 9> Terms(const R3::Vector& N) {
  return {1, N.y, N.z, N.x, N.x * N.y, N.y * N.z, 3 * N.z * N.z - 1, N.x * N.z, N.x * N.x - N.y * N.y};
}

/// For each spherical harmonic, the square of its constant factor times what the cosine leaves of its band: 1, 2/3,
/// 1/4.
constexpr std::array<double, 9> weights{1 / (4 * pi),           2.0 / 3 * 3 / (4 * pi), 2.0 / 3 * 3 / (4 * pi),
                                        2.0 / 3 * 3 / (4 * pi), 0.25 * 15 / (4 * pi),   0.25 * 15 / (4 * pi),
                                        0.25 * 5 / (16 * pi),   0.25 * 15 / (4 * pi),   0.25 * 15 / (16 * pi)};

}  // namespace

R2::Color DiffuseLight::At(const R3::Vector& N) const {
  const auto terms = Terms(N);
  R2::Color sum;
  for (std::size_t i = 0; i < terms.size(); ++i) sum += terms[i] * factors[i];
  return {std::max(0.0, sum.r), std::max(0.0, sum.g), std::max(0.0, sum.b)};
}

DiffuseLight DiffuseLightOf(const R2::Color& radiance) {
  DiffuseLight light;
  light.factors[0] = radiance;
  return light;
}

DiffuseLight DiffuseLightOf(const Environment& environment) {
  const R2::Image map = Shrunk(environment.Map(), columns_of_diffuse, columns_of_diffuse / 2);
  DiffuseLight light;
  for (int y = 0; y < map.Height(); ++y) {
    const double low = pi * y / map.Height() - pi / 2, high = pi * (y + 1) / map.Height() - pi / 2;
    const double solid_angle = (R1::Sin(high) - R1::Sin(low)) * 2 * pi / map.Width();
    const double sine = (R1::Sin(low) + R1::Sin(high)) / 2, radius = std::sqrt(1 - sine * sine);
    for (int x = 0; x < map.Width(); ++x) {
      const double longitude = 2 * pi * (x + 0.5) / map.Width() - pi;  // from -z by +x; see EnvironmentLayout
      const auto terms = Terms({radius * R1::Sin(longitude), sine, -radius * R1::Cos(longitude)});
      const R2::Color arriving = solid_angle * map.At(x, y);
      for (std::size_t i = 0; i < terms.size(); ++i) light.factors[i] += weights[i] * terms[i] * arriving;
    }
  }
  return light;
}

R2::Image Shrunk(const R2::Image& image, int width, int height) {
  if (image.Width() <= width && image.Height() <= height) return image;
  R2::Image shrunk(std::min(width, image.Width()), std::min(height, image.Height()));
  const auto edge = [](int i, int count, int of) { return static_cast<int>(std::int64_t{i} * of / count); };
  for (int y = 0; y < shrunk.Height(); ++y) {
    const int bottom = edge(y, shrunk.Height(), image.Height()), top = edge(y + 1, shrunk.Height(), image.Height());
    for (int x = 0; x < shrunk.Width(); ++x) {
      const int left = edge(x, shrunk.Width(), image.Width()), right = edge(x + 1, shrunk.Width(), image.Width());
      R2::Color sum;
      for (int j = bottom; j < top; ++j)
        for (int i = left; i < right; ++i) sum += image.At(i, j);
      shrunk.Set(x, y, sum / ((right - left) * (top - bottom)));
    }
  }
  return shrunk;
}

}  // namespace ray
