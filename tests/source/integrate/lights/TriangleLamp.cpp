#include "source/integrate/lights/TriangleLamp.h"

#include <gtest/gtest.h>

#include "tests/Project.h"
#include "tests/Statistics.h"

namespace ray {
namespace {

const std::string emissive = "material 0 0 0  0 0 0  0 0 0  0 0 0  2 2 2  1 1 0 ";

/// Returns the color of a small gray patch of floor at the origin under a light, in mode whitted.
statistics::Mean FloorUnder(const std::string& lamp, int lights = -1) {
  const project::Stage stage(project::FromText(
      "camera 0.3 0.4 0  -3 -4 0  0 0 -1  1e-7  0.01 100 point_light 0 0 0  0 9 0  1 0 0 " + emissive +
      "material 0 0 0  0.5 0.5 0.5  0 0 0  0 0 0  0 0 0  1 1 0 box 1  -1 -1 -1  1 0 1 " + lamp));
  RenderSettings settings = project::Sized(16);
  settings.samples = 16;
  settings.trace.lights = lights;
  return statistics::MeanOverPixels(project::Render(stage, settings).image);
}

/// Returns the mean cosine at the origin over an upright rectangle at the height h, times kd e, by a sum over its
/// points.
double FloorUnderRectangle(double x0, double x1, double z0, double z1, double h) {
  constexpr int n = 1000;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = x0 + (x1 - x0) * (i + 0.5) / n, z = z0 + (z1 - z0) * (j + 0.5) / n;
      sum += h / std::sqrt(x * x + h * h + z * z);
    }
  return 0.5 * 2 * sum / n / n;
}

// A fan from the first corner: triangles of very different areas, one of them degenerate.
const char* const as_quad = "quad 0  -1 1.5 -1  2 1.5 -1  2 1.5 1  -1 1.5 1";
const char* const as_polygon =
    "polygon 0 7  -1 1.5 -1  0 1.5 -1  2 1.5 -1  2 1.5 .9  2 1.5 1  1.9 1.5 1  -1 1.5 1";

TEST(TriangleLamp, QuadsAndPolygonsLightByTheMeanOfTheirPoints) {
  const double truth = FloorUnderRectangle(-1, 2, -1, 1, 1.5);
  for (const char* lamp : {as_quad, as_polygon})
    for (const int lights : {-1, 1, 3}) {
      const statistics::Mean m = FloorUnder(lamp, lights);
      EXPECT_LT(std::abs(statistics::Deviations(m, truth, 1e-6)), 4) << lamp << ": " << m.mean << ", not " << truth;
      EXPECT_LT(m.deviation, 0.01 * truth) << "too noisy to tell";
    }
}

TEST(TriangleLamp, EachTriangleIsALamp) {
  const std::string low = "tri 0  -1 1.5 -1  2 1.5 -1  2 1.5 1 ", high = "tri 0  -1 1.5 -1  2 1.5 1  -1 1.5 1 ";
  const double sum = FloorUnder(low).mean + FloorUnder(high).mean;
  EXPECT_NEAR(FloorUnder(low + high).mean, sum, 1e-4 * sum);  // drawn by other random numbers
  EXPECT_GT(sum, 1.7 * FloorUnder(as_quad).mean);
}

TEST(TriangleLamp, AMeshIsOneLampOrOnePerFace) {
  R3::MeshData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  data.triangles = {{0, 1, 2}, {0, 2, 3}};
  Scene scene = project::FromText(emissive + "tri 0  0 0 0  1 0 0  0 1 0");
  for (const bool is_one : {false, true}) {
    data.is_one_polygon = is_one;
    scene.root.children.back().shape = std::make_shared<const R3::Mesh>(data);
    const World world(scene);
    EXPECT_EQ(TriangleLamps(world, EmissiveMeshes::faces).size(), is_one ? 1u : 2u);
    EXPECT_EQ(TriangleLamps(world, EmissiveMeshes::whole).size(), 1u);
  }
}

TEST(TriangleLamp, PolygonsAreSampledAsEvenlyAsTriangles) {
  const project::Stage stage(project::FromText(emissive + as_polygon));
  const std::vector<TriangleLamp> lamps = TriangleLamps(stage.world, EmissiveMeshes::faces);
  ASSERT_EQ(lamps.size(), 1u);
  // Strata of equal area: fractions of the random numbers' square are fractions of the light.
  constexpr int n = 512;
  double x = 0, z = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const R3::Point at = R3::Point{} + lamps[0].SampleTowards({}, {(i + 0.5) / n, (j + 0.5) / n}, 0).to_light;
      EXPECT_TRUE(at.x > -1 && at.x < 2 && at.z > -1 && at.z < 1) << at.x << " " << at.z;
      x += at.x / n / n, z += at.z / n / n;
    }
  EXPECT_NEAR(x, 0.5, 0.003);
  EXPECT_NEAR(z, 0, 0.003);
}

TEST(TriangleLamp, DoesNotLightItself) {
  const project::Stage stage(
      project::FromText(emissive + "quad 0  0 0 0  1 0 0  1 1 0  0 1 0 tri 0  2 0 0 3 0 0 2 1 0"));
  const std::vector<TriangleLamp> lamps = TriangleLamps(stage.world, EmissiveMeshes::faces);
  ASSERT_EQ(lamps.size(), 2u);
  for (std::int64_t primitive = 0; primitive < 3; ++primitive) {
    EXPECT_EQ(lamps[0].Holds(primitive), primitive < 2);
    EXPECT_EQ(lamps[1].Holds(primitive), primitive == 2);
  }
}

TEST(TriangleLamp, KnowsItsAreaItsBoundsAndItsTriangles) {
  const project::Stage stage(project::FromText(emissive + as_polygon));
  const TriangleLamp lamp = TriangleLamps(stage.world, EmissiveMeshes::faces).at(0);
  EXPECT_NEAR(lamp.Area(), 6, 1e-12);
  EXPECT_EQ(lamp.Bound().center, (R3::Point{0.5, 1.5, 0}));
  EXPECT_NEAR(lamp.Bound().radius, std::hypot(1.5, 1), 1e-9);
  EXPECT_EQ(lamp.Describe(), "lamp of 4 emissive triangles, primitives 0 to 3");
}

// At the end of the range of doubles areas are infinite, and their ratios NaN.
TEST(TriangleLamp, OfAnySizeGivesFinitePoints) {
  for (const char* size : {"1e-160", "1e160"}) {
    const std::string s = size;
    const project::Stage stage(project::FromText(emissive + "begin -1  " + s + " 0 0 0  0 " + s + " 0 0  0 0 " + s +
                                                 " 0  0 0 0 1 quad 0  0 0 0  1 0 0  1 1 0  0 1 0 end"));
    for (const TriangleLamp& lamp : TriangleLamps(stage.world, EmissiveMeshes::faces))
      for (const double u : {0.1, 0.6, 0.9})
        EXPECT_TRUE(R3::IsFinite(lamp.SampleTowards({1, 1, 1}, {u, 0.5}, 0).to_light)) << size;
  }
}

}  // namespace
}  // namespace ray
