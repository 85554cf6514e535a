#pragma once

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

#include "source/render/RenderSettings.h"
#include "source/scene/Scene.h"
#include "tests/Project.h"

/// Scenes to measure the trade of time for accuracy with, each with one source of noise or a known mixture.
namespace trade {

inline constexpr int usual_side = 64;  // of pictures, in pixels

/// What is rendered: a scene and how.
struct Subject {
  std::string name;
  ray::Scene scene;
  ray::RenderSettings settings;
  bool counts_shadow_rays = false;  // a number of samples is of shadow rays from the one point seen at pixels' centers
};

inline std::string Line(const char* format, auto... numbers) {
  char text[400];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

/// Edges alone: overlapping triangles and balls, each as bright all over.
inline std::string EdgesText() {
  std::string text = "camera 0 0 5  0 0 -1  0 1 0  0.4  0.01 100\nambient 1 1 1\nbackground 0.1 0.1 0.15\n";
  std::mt19937_64 random(5);
  const auto number = [&] { return std::generate_canonical<double, 53>(random); };
  for (int i = 0; i < 24; ++i)
    text += Line("material %g %g %g  0 0 0  0 0 0  0 0 0  0 0 0  1 1 0\n", number(), number(), number());
  for (int i = 0; i < 24; ++i) {
    const double x = 4 * number() - 2, y = 4 * number() - 2, z = -number();
    if (i % 3 == 0)
      text += Line("sphere %d  %g %g %g  %g\n", i, x, y, z, 0.1 + 0.3 * number());
    else
      text += Line("tri %d  %g %g %g  %g %g %g  %g %g %g\n", i, x, y, z, x + 0.3 + number(), y + number() - 0.5, z,
                   x + number() - 0.5, y + 0.3 + number(), z);
  }
  return text;
}

/// Point lights here and there above a floor with a few balls.
inline std::string LightsText(int count) {
  std::string text =
      "camera 0 4 11  0 -0.4 -1  0 1 0  0.5  0.01 100\n"
      "material 0 0 0  0.6 0.6 0.6  0 0 0  0 0 0  0 0 0  1 1 0\n"
      "material 0 0 0  0.7 0.4 0.3  0 0 0  0 0 0  0 0 0  1 1 0\n"
      "box 0  -10 -1 -10  10 0 10\n"
      "sphere 1  -2 1 0  1\nsphere 1  2.5 0.8 1.5  0.8\nsphere 1  0.5 0.6 3  0.6\n";
  std::mt19937_64 random(9);
  const auto number = [&] { return std::generate_canonical<double, 53>(random); };
  for (int i = 0; i < count; ++i) {
    const double bright = 20.0 / count * (0.2 + number());
    text += Line("point_light %g %g %g  %g %g %g  0 0 1\n", bright, bright * (0.6 + 0.4 * number()),
                 bright * (0.4 + 0.6 * number()), 20 * number() - 10, 0.3 + 1.7 * number(), 20 * number() - 10);
  }
  return text;
}

/// A smooth sky and a sun of 2x2 of its 256x128 texels, a hundred thousand times as bright.
inline R2::Image SkyWithSun() {
  R2::Image sky(256, 128);
  for (int y = 0; y < sky.Height(); ++y)
    for (int x = 0; x < sky.Width(); ++x) {
      const double up = std::sin(std::numbers::pi * ((y + 0.5) / sky.Height() - 0.5));
      const double turn = 0.1 * std::cos(2 * std::numbers::pi * x / sky.Width());
      sky.Set(x, y, {0.35 + 0.15 * up + turn, 0.45 + 0.2 * up + turn, 0.6 + 0.3 * up});
    }
  for (int y = 100; y < 102; ++y)
    for (int x = 40; x < 42; ++x) sky.Set(x, y, {3000, 2700, 2200});
  return sky;
}

inline constexpr const char* sky_text =
    "camera 0 1.2 5  0 -1.1 -5  0 1 0  0.349065850  0.01 100\n"
    "material 0 0 0  0.25 0.2 0.15  0.5 0.5 0.5  0 0 0  0 0 0  100 1 0\n"
    "material 0 0 0  0.4 0.4 0.4  0 0 0  0 0 0  0 0 0  1 1 0\n"
    "sphere 0  0 0 0  1\n"
    "tri 1  -20 -1 -20  -20 -1 20  20 -1 20\ntri 1  -20 -1 -20  20 -1 20  20 -1 -20\n";

/// A disc of light over a floor: no edge in the picture, none in the light.
inline constexpr const char* disc_text =
    "camera 0 3 0.01  0 -1 0  0 0 -1  0.5  0.01 100\n"
    "material 0 0 0  0.8 0.7 0.6  0 0 0  0 0 0  0 0 0  1 1 0\n"
    "area_light 3 3 3  0.5 2.5 0.3  0 -1 0  0.4  0 0 1\n"
    "tri 0  -9 0 -9  -9 0 9  9 0 9\ntri 0  -9 0 -9  9 0 9  9 0 -9\n";

/// One plane with a picture on it, seen askew.
inline constexpr const char* flat_text =
    "camera 0.1 0 1.2  0 0.05 -1  0 1 0  0.4  0.01 100\ndir_light 0.9 0.9 0.9  0 0 -1\n"
    "material 0 0 0  1 1 1  0 0 0  0 0 0  0 0 0  1 1 scenes/textures/compass.ppm\n"
    "tri 0  -4 -4 0  4 -4 0  -4 4 -0.5\ntri 0  4 -4 0  4 4 -0.5  -4 4 -0.5\n";

/// Mirrors, bent light and soft shadows.
inline constexpr const char* glass_text =
    "camera 0 1.2 6  0 -0.12 -1  0 1 0  0.3  0.01 100\nbackground 0.3 0.4 0.5\nambient 0.1 0.1 0.1\n"
    "area_light 8 8 7  2 4 2  -2 -4 -2  0.5  0 0 1\n"
    "material 1 1 1  0.5 0.5 0.4  0.2 0.2 0.2  0 0 0  0 0 0  30 1 0\n"
    "material 0 0 0  0.02 0.02 0.02  0.1 0.1 0.1  0.9 0.9 0.9  0 0 0  100 1.5 0\n"
    "material 0 0 0  0.05 0.05 0.05  0.8 0.8 0.8  0 0 0  0 0 0  100 1 0\n"
    "material 1 1 1  0.7 0.2 0.2  0 0 0  0 0 0  0 0 0  10 1 0\n"
    "box 0  -4 -1 -4  4 0 4\nsphere 1  -0.7 0.7 1  0.7\nsphere 2  0.9 0.7 0.2  0.7\nsphere 3  0.2 0.4 -1.4  0.4\n";

/// The subject of a name:
///   box1       a room lit by a disc, one shadow ray: the pixel's edges and the light together
///   box5       the same with light over up to four bounces
///   dof        a lens, a light with an area, edges out of focus
///   pixel      edges alone
///   light      penumbras alone: box1 at the pixels' centers, samples are shadow rays
///   disc       a light with an area alone, no shadow: smooth
///   sky        a hot sun in a sky, a glossy ball and a floor
///   lights64, lights1024   one of many lights a point, chosen by importance
///   flat       a texture alone
///   depth      mirrors, glass and soft shadows
/// A number after @ is the side of its picture.
inline Subject MakeSubject(const std::string& name_and_side) {
  const auto at = name_and_side.find('@');
  const std::string name = name_and_side.substr(0, at);
  Subject s{.name = name, .scene = {}, .settings = {}};
  s.settings.width = s.settings.height = at == std::string::npos ? usual_side : std::stoi(name_and_side.substr(at + 1));
  const auto read = [](const char* file) { return ray::Parse(project::Root() / "scenes" / file, {}).scene; };
  const auto straight = [&](int shadow_samples) {
    s.settings.trace.max_depth = 0;
    s.settings.trace.shadow_samples = shadow_samples;
  };
  const auto path = [&](int max_depth) {
    s.settings.mode = ray::RenderMode::path;
    s.settings.trace.max_depth = max_depth;
  };
  if (name == "box1" || name == "light") {
    s.scene = read("indirect.scn");
    s.counts_shadow_rays = name == "light";
    straight(1);
  } else if (name == "box5") {
    s.scene = read("indirect.scn");
    s.settings.trace.roulette = ray::Roulette::off;
    path(4);
  } else if (name == "dof") {
    s.scene = read("lens.scn");
    s.settings.camera.aperture = 0.12;
    s.settings.camera.focus = 5;
    straight(1);
  } else if (name == "pixel" || name == "disc" || name == "flat") {
    s.scene = project::FromText(name == "pixel" ? EdgesText() : name == "disc" ? disc_text : flat_text);
    straight(1);
  } else if (name == "sky") {
    s.scene = project::FromText(sky_text);
    s.scene.environment = std::make_shared<ray::Environment>(SkyWithSun());
    s.settings.trace.glossy = true;
    path(0);
  } else if (name == "lights64" || name == "lights1024") {
    s.scene = project::FromText(LightsText(name == "lights64" ? 64 : 1024));
    s.settings.trace.lights = 1;
    path(0);
  } else if (name == "depth") {
    s.scene = project::FromText(glass_text);
    s.settings.trace.shadow_samples = 1;
    s.settings.trace.max_depth = 5;
    s.settings.trace.fresnel = true;
  } else {
    throw std::invalid_argument("no scene is called " + name);
  }
  return s;
}

}  // namespace trade
