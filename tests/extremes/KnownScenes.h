#pragma once

#include <array>
#include <charconv>
#include <memory>
#include <optional>
#include <string>

#include "R2/Image.h"
#include "tests/Statistics.h"

/// Scenes written in place, and settings whose pictures have the mean that they should have.
namespace statistics {

inline const std::string no_light = " point_light 0 0 0  0 9 0  1 0 0 ";  // keeps the default lights away

inline std::string Words(double x) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

/// "material 0 0 0 ...", gray.
inline std::string Material(double kd, double ks, double kt, double emission, double n = 10, double ir = 1) {
  const auto gray = [](double x) { return Words(x) + " " + Words(x) + " " + Words(x) + "  "; };
  return " material 0 0 0  " + gray(kd) + gray(ks) + gray(kt) + gray(emission) + Words(n) + " " + Words(ir) + " 0 ";
}

inline R2::Image UniformSky(double light) {
  R2::Image image(16, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 16; ++x) image.Set(x, y, {light, light, light});
  return image;
}

inline project::Stage StageOf(const std::string& text, const std::optional<R2::Image>& environment = {}) {
  ray::Scene scene = project::FromText(text);
  if (environment) scene.environment = std::make_shared<const ray::Environment>(*environment);
  return project::Stage(std::move(scene));
}

inline ray::RenderSettings Path(int side, int samples) {
  ray::RenderSettings s;
  s.width = s.height = side;
  s.samples = samples;
  s.mode = ray::RenderMode::path;
  s.trace.max_depth = 1000;
  return s;
}

inline ray::RenderSettings Whitted(int side, int samples) {
  ray::RenderSettings s = Path(side, samples);
  s.mode = ray::RenderMode::whitted;
  s.trace.min_luminance = 0;
  s.trace.shadow_samples = 1;
  return s;
}

}  // namespace statistics
