// Rays of another tracer beside ours: the first that differs is found, and its mistake named.
#include "source/inspect/ForeignRays.h"

#include <gtest/gtest.h>

#include <cmath>

#include "source/inspect/LoadedScene.h"
#include "tests/Project.h"

namespace ray {
namespace {

/// A tracer of one's own in a few lines, for a mirror and a glass ball over a floor: it shares no code with ours.
struct Student {
  double eta_in = 1 / 1.5;     // as it enters glass
  double sign = 1;             // of the mirrored direction
  double tangent = std::tan(0.4);
  bool has_offset = true, forgets_shadow = false;

  std::vector<ForeignRay> Trace(double x, double y, double w, double h, bool mirror) const {
    std::vector<ForeignRay> rays;
    const R3::Point eye{0, 1, 6};
    const double sx = (2 * (x + 0.5) / w - 1) * tangent, sy = (2 * (y + 0.5) / h - 1) * tangent * h / w;
    const R3::Vector d = Unit(R3::Vector{sx, sy, -1});
    // The ball about (0, 1, 0) of radius 1.
    const R3::Vector to = eye - R3::Point{0, 1, 0};
    const double b = Dot(to, d), c = Dot(to, to) - 1, disc = b * b - c;
    if (disc < 0) return {{RayKind::camera, eye, eye + 100.0 * d}};
    const R3::Point p = eye + (-b - std::sqrt(disc)) * d;
    const R3::Vector n = p - R3::Point{0, 1, 0};
    rays.push_back({RayKind::camera, eye, p});
    const R3::Point light{3, 5, 6};
    if (!forgets_shadow) rays.push_back({RayKind::shadow, p, light});
    if (mirror) {
      const R3::Vector r = sign * (d - 2 * Dot(d, n) * n);
      rays.push_back({RayKind::reflection, p, has_offset ? p + 100.0 * r : p});
      return rays;
    }
    const double cosine = -Dot(d, n), squared = 1 - eta_in * eta_in * (1 - cosine * cosine);
    const R3::Vector t = eta_in * d + (eta_in * cosine - std::sqrt(std::max(0.0, squared))) * n;
    rays.push_back({RayKind::transmission, p, has_offset ? p + 2 * -Dot(t, n) * t : p});
    return rays;
  }
};

LoadedScene Ball(bool mirror) {
  ParsedScene parsed;
  parsed.scene = project::FromText(
      "camera 0 1 6  0 0 -1  0 1 0  0.4  0.01 100\npoint_light 1 1 1  3 5 6  1 0 0\nmaterial 0.1 0.1 0.1  " +
      std::string(mirror ? "0.5 0.5 0.5  0.5 0.5 0.5  0 0 0" : "0 0 0  0 0 0  0.5 0.5 0.5") + "  0 0 0  10 1.5 0\n" +
      "sphere 0  0 1 0  1\n");
  return LoadedScene(std::move(parsed), AcceleratorSettings{});
}

std::string Verdict(const Student& student, bool mirror, int column = 44, int row = 30) {
  const LoadedScene scene = Ball(mirror);
  RenderSettings settings = project::Sized(80, 60);
  settings.trace.sampler = SamplerKind::grid;
  settings.trace.max_depth = 1;
  const auto foreign = student.Trace(column, row, 80, 60, mirror);
  const auto pixel = PixelOf({{}, foreign}, scene.parsed.scene.camera, settings);
  EXPECT_TRUE(pixel && (student.tangent != std::tan(0.4) || (pixel->column == column && pixel->row == row)));
  const PixelTrace ours = PixelTracer(scene.world, *scene.accelerator, settings).Trace(column, row, 1);
  const auto found = FirstDifference(ours, foreign, scene.world, settings);
  return found ? found->text : "none";
}

bool Says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(ForeignRays, OfARightTracerDoNotDiffer) {
  for (const bool mirror : {true, false})
    for (const int column : {36, 40, 44})
      for (const int row : {26, 30, 35}) EXPECT_EQ(Verdict({}, mirror, column, row), "none");
}

TEST(ForeignRays, OfWrongTracersAreNamed) {
  EXPECT_TRUE(Says(Verdict({.eta_in = 1.5}, false), "transmission ray at depth 1")) << Verdict({.eta_in = 1.5}, false);
  EXPECT_TRUE(Says(Verdict({.eta_in = 1.5}, false), "refraction with eta inverted")) << Verdict({.eta_in = 1.5}, false);
  EXPECT_TRUE(Says(Verdict({.eta_in = 1}, false), "goes straight on")) << Verdict({.eta_in = 1}, false);
  EXPECT_TRUE(Says(Verdict({.sign = -1}, true), "opposite way")) << Verdict({.sign = -1}, true);
  EXPECT_TRUE(Says(Verdict({.has_offset = false}, false), "ends where it starts"));
  EXPECT_TRUE(Says(Verdict({.forgets_shadow = true}, true), "a ray is missing: shadow ray at depth 0"))
      << Verdict({.forgets_shadow = true}, true);
  EXPECT_TRUE(Says(Verdict({.tangent = std::tan(0.2)}, true, 60, 30), "half angle is taken for the whole"))
      << Verdict({.tangent = std::tan(0.2)}, true, 60, 30);
}

TEST(ForeignRays, AreReadAsLinesAndAsObj) {
  const ForeignRays read =
      ReadForeignRays({"rays", "# mine\npixel 3 4\ncamera 0 0 5  0 0 1\nshadow 0 0 1  1 2 3 0.5\n"});
  ASSERT_TRUE(read.pixel);
  EXPECT_EQ(read.pixel->row, 4);
  const auto& lines = read.rays;
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[1].kind, RayKind::shadow);
  EXPECT_EQ(lines[1].to, (R3::Point{1, 2, 3}));
  const auto obj = ReadForeignRays({"rays", "g reflection\nv 0 0 0\nv 1 2 3\nl 1 2\n"}).rays;
  ASSERT_EQ(obj.size(), 1u);
  EXPECT_EQ(obj[0].kind, RayKind::reflection);
  EXPECT_TRUE(IsForeignRays({"mine.rays", "camera 0 0 5  0 0 1\n"}));
  EXPECT_TRUE(IsForeignRays({"rays1.obj", "g camera\nv 0 0 0\n"}));
  EXPECT_FALSE(IsForeignRays({"a.scn", "camera 0 0 5  0 0 1\n 0 1 0  0.5 1 2\n"}));
  EXPECT_FALSE(IsForeignRays({"mesh.obj", "v 0 0 0\n"}));
  EXPECT_FALSE(IsForeignRays({"nothing.obj", ""}));
}

TEST(ForeignRays, ThatCannotBeReadArePointedAt) {
  for (const auto& [text, line, part] : {std::tuple{"camera 0 0 5  0 0\n", 1u, "missing"},
                                         {"camera 0 0 5  0 0 1\ncamra 0 0 0 0 0 0\n", 2u, "no kind of ray"},
                                         {"shadow 0 0 x  1 1 1\n", 1u, "coordinate"},
                                         {"pixel 3 -4\n", 1u, "no column or row"},
                                         {"shadow 0 0 nan  1 1 1\n", 1u, "coordinate"},
                                         {"g camera\nv 0 0 0\nl 1 7\n", 3u, "no vertex"}}) {
    try {
      ReadForeignRays({"rays", text});
      ADD_FAILURE() << text;
    } catch (const SceneErrors& errors) {
      EXPECT_EQ(errors.All().front().line, line) << text;
      EXPECT_TRUE(Says(errors.All().front().message, part)) << errors.All().front().message;
    }
  }
}

}  // namespace
}  // namespace ray
