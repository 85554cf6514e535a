// Surfaces that touch, as pictures and paths see them: lamps on surfaces, what stands on what, stacks, solids in
// solids, and surfaces in one plane. If this fails, lamps in ceilings are dark, what stands on a floor hides it, and
// water in a glass looks like air.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "source/integrate/Tracer.h"
#include "source/integrate/shading/Bsdf.h"
#include "tests/Accelerators.h"
#include "tests/Project.h"
#include "tests/Quad.h"
#include "tests/extremes/KnownScenes.h"

namespace statistics {
namespace {

using ray::LightStrategy;
using ray::RenderMode;
using ray::RenderSettings;

double MeanOf(const R2::Image& image) {
  double sum = 0;
  for (const float channel : image.Channels()) sum += static_cast<double>(channel);
  return sum / static_cast<double>(image.Channels().size());
}

// A lamp in, on or touching a ceiling lights the floor as it does a millionth below, whatever both are made of.

struct Lamp {
  const char* name;
  std::string commands;   // with "Y" for its height, of material 1 if it is a shape
  bool is_solid = false;  // samples then fall elsewhere on it, if it is moved by ever so little
};

const std::string corners = "-1 Y -1  1 Y -1  1 Y 1  -1 Y 1";

std::vector<Lamp> Lamps() {
  return {
      {"area_light", "area_light 4 4 4  0 Y 0  0 -1 0  1  1 0 0"},
      {"point_light", "point_light 4 4 4  0 Y 0  1 0 0"},
      {"sphere_light", "sphere_light 4 4 4  0 Y-0.5 0  0.5  1 0 0"},
      {"quad", "quad 1 " + corners},
      {"polygon", "polygon 1 4 " + corners},
      {"triangles", "tri 1 -1 Y -1  1 Y -1  1 Y 1  tri 1 -1 Y -1  1 Y 1  -1 Y 1"},
      {"disc", "disc 1 0 Y 0  0 1 0  1"},
      {"box", "box 1 -1 Y-0.25 -1  1 Y 1", true},
      {"sphere", "sphere 1 0 Y-0.5 0  0.5", true},
      {"cylinder", "cylinder 1 0 Y-0.5 0  0.5 1", true},
      {"cone", "cone 1 0 Y-0.5 0  0.5 1", true},
      {"torus", "torus 1 0 Y-0.25 0  1 0.25", true},
  };
}

/// "Y" and "Y-0.5" become numbers.
std::string AtHeight(std::string commands, double y) {
  for (std::size_t at; (at = commands.find('Y')) != std::string::npos;) {
    double below = 0;
    std::size_t length = 1;
    if (commands.compare(at, 2, "Y-") == 0) {
      const std::size_t end = commands.find(' ', at);
      below = std::stod(commands.substr(at + 2, end - at - 2));
      length = end - at;
    }
    commands.replace(at, length, Words(y - below));
  }
  return commands;
}

struct Ceiling {
  const char* name;
  const char* commands;
};
constexpr Ceiling ceilings[] = {
    {"quad", "quad 0 -3 2 -3  3 2 -3  3 2 3  -3 2 3"},
    {"polygon", "polygon 0 5 -3 2 -3  3 2 -3  4 2 0  3 2 3  -3 2 3"},
    {"triangles", "tri 0 -3 2 -3  3 2 -3  3 2 3  tri 0 -3 2 -3  3 2 3  -3 2 3"},
    {"box", "box 0 -3 2 -3  3 3 3"},
    {"plane", "plane 0 0 2 0  0 -1 0"},
    {"disc", "disc 0 0 2 0  0 -1 0  4"},
    {"cylinder", "cylinder 0 0 2.5 0  4 1"},
};

std::string LampScene(const Lamp& lamp, double y, const char* ceiling) {
  return "camera 0 1.2 0  0.1 -1 0  0 0 -1  0.6 0.01 100 ambient 0 0 0 background 0 0 0 " + no_light +
         Material(0.5, 0, 0, 0) + Material(0, 0, 0, 4) + "quad 0 -3 0 -3  3 0 -3  3 0 3  -3 0 3\n" +
         AtHeight(lamp.commands, y) + "\n" + ceiling + "\n";
}

TEST(Extremes, M3_LampsOnASurfaceLightLikeThoseJustBelow) {
  for (const Ceiling& ceiling : ceilings)
    for (const Lamp& lamp : Lamps()) {
      const project::Stage flush = StageOf(LampScene(lamp, 2, ceiling.commands));
      const project::Stage below = StageOf(LampScene(lamp, 2 - 1e-6, ceiling.commands));
      const auto compare = [&](const RenderSettings& s, const std::string& how) {
        const double a = MeanOf(project::Render(flush, s).image), b = MeanOf(project::Render(below, s).image);
        EXPECT_NEAR(a, b, (lamp.is_solid ? 0.04 : 1e-3) * b) << lamp.name << " in " << ceiling.name << ", " << how;
        EXPECT_GT(b, 0.01) << lamp.name << " in " << ceiling.name << ", " << how;
      };
      RenderSettings whitted = Whitted(12, 1);
      whitted.trace.shadow_samples = 16;
      whitted.trace.emissive_solids_light = true;
      compare(whitted, "whitted");
      RenderSettings path = Path(12, 16);
      path.trace.max_depth = 1;
      for (const auto strategy : {LightStrategy::light, LightStrategy::mis, LightStrategy::bsdf}) {
        const bool is_light = std::string(lamp.name).find("light") != std::string::npos;
        if (is_light && strategy == LightStrategy::bsdf) continue;  // rays do not find it
        path.trace.strategy = strategy;
        compare(path, std::string(ray::strategy_names[static_cast<std::size_t>(strategy)]));
      }
    }
}

// The commonest way to write a room: walls first, then a lamp in the plane of one of them.
TEST(Extremes, M3_M7_ALampInThePlaneOfAnEarlierSurfaceShinesAsIfNamedFirst) {
  for (const char* name : {"quad", "polygon", "triangles", "disc"}) {
    const auto lamps = Lamps();
    const auto lamp = std::ranges::find_if(lamps, [&](const Lamp& l) { return std::string(l.name) == name; });
    for (const Ceiling& ceiling : ceilings) {
      std::string text = LampScene(*lamp, 2, "");
      text.insert(text.find("quad 0"), std::string(ceiling.commands) + " ");
      const project::Stage stage = StageOf(text), reversed = StageOf(LampScene(*lamp, 2, ceiling.commands));
      const auto compare = [&](const RenderSettings& s) {
        const double mean = MeanOf(project::Render(stage, s).image);
        EXPECT_GT(mean, 0.01) << name << " in " << ceiling.name;
        EXPECT_EQ(mean, MeanOf(project::Render(reversed, s).image)) << name << " in " << ceiling.name;
      };
      for (const auto strategy : {LightStrategy::light, LightStrategy::mis, LightStrategy::bsdf}) {
        RenderSettings path = Path(8, 4);
        path.trace.strategy = strategy;
        compare(path);
      }
      RenderSettings whitted = Whitted(8, 4);
      whitted.trace.emissive_solids_light = true;
      compare(whitted);
    }
  }
}

// What stands on something looks as it does a ten-millionth above, in either order of the file.

constexpr const char* standing[] = {
    "sphere M 0 0.7 0  0.7",
    "box M -0.6 0 -0.6  0.6 1 0.6",
    "cylinder M 0 0.5 0  0.6 1",
    "cone M 0 0.6 0  0.7 1.2",
    "torus M 0 0.25 0  0.6 0.25",
    "disc M 0 0.5 0  0.3 0.2 1  0.5",
    "quad M -0.5 0 0  0.5 0 0  0.5 1 0.3  -0.5 1 0.3",
    "tri M -0.6 0 0  0.6 0 0  0 1 0.2",
};
constexpr const char* floors[] = {
    "quad 0 -3 0 -3  3 0 -3  3 0 3  -3 0 3",
    "tri 0 -3 0 -3  3 0 3  3 0 -3  tri 0 -3 0 -3  -3 0 3  3 0 3",
    "box 0 -3 -1 -3  3 0 3",
    "plane 0 0 0 0  0 1 0",
    "polygon 0 3 -4 0 3  4 0 3  0 0 -5",
};

std::string StandingScene(std::string thing, const char* floor, bool is_floor_first, double above, int material) {
  thing.replace(thing.find('M'), 1, std::to_string(material));
  thing = "begin 0  1 0 0 0  0 1 0 " + Words(above) + "  0 0 1 0  0 0 0 1  " + thing + " end ";
  return "camera 0.3 1.1 4.1  -0.05 -0.2 -1  0 1 0  0.3 0.01 100 ambient .1 .1 .1 background 0.3 0.4 0.5 "
         "dir_light 1 1 1  0.3 -1 -0.4 point_light 1 1 1  1 3 2  1 0 0 " +
         Material(0.6, 0, 0, 0) + Material(0.2, 0.3, 0, 0) + Material(0, 0.1, 0.9, 0, 10, 1.5) +
         Material(0.1, 0, 0.8, 0) + "absorb 3  0.3 0.2 0.1 " + (is_floor_first ? floor + (" " + thing) : thing + floor);
}

TEST(Extremes, M4_StandingObjectsLookAsIfJustAboveTheFloor) {
  RenderSettings s = Whitted(40, 1);
  s.trace.max_depth = 8;
  std::size_t pixels = 0, different = 0;
  for (const char* floor : floors)
    for (const char* thing : standing)
      for (const int material : {1, 2, 3}) {
        const R2::Image apart = project::Render(StageOf(StandingScene(thing, floor, true, 1e-7, material)), s).image;
        for (const bool is_floor_first : {false, true}) {
          const R2::Image touching =
              project::Render(StageOf(StandingScene(thing, floor, is_floor_first, 0, material)), s).image;
          std::size_t here = 0;
          for (std::size_t i = 0; i < apart.Channels().size(); ++i)
            here += std::abs(apart.Channels()[i] - touching.Channels()[i]) > 1e-3f;
          pixels += 1600, different += here;
          EXPECT_LE(here, 9u) << thing << ", material " << material << ", on " << floor << ", first " << is_floor_first;
        }
      }
  std::printf("%zu of %zu pixels differ\n", different / 3, pixels);
}

// Slabs on one another absorb what all of them absorb, in whatever order they are listed.
TEST(Extremes, M5_AStackOfSlabsAbsorbsTheSumOfThem) {
  constexpr int slabs = 10;
  const auto stage_of = [&](const std::vector<int>& order, double index, const std::string& around) {
    std::string text = around + no_light + "ambient 0 0 0 background 1 1 1 ";
    for (int i = 0; i < slabs; ++i)
      text += Material(0, 0, 1, 0, 10, index) + "absorb " + std::to_string(i) + " " + Words(0.02 * (i + 1)) + " " +
              Words(0.03 * i) + " " + Words(0.1 / (i + 1)) + " ";
    for (const int i : order)
      text += "box " + std::to_string(i) + " -30 " + Words(0.3 * i) + " -30  30 " + Words(0.3 * (i + 1)) + " 30 ";
    return StageOf(text);
  };
  R2::Color sum{};
  for (int i = 0; i < slabs; ++i) sum += R2::Color{0.02 * (i + 1), 0.03 * i, 0.1 / (i + 1)};
  Draw draw(5);
  std::vector<int> order(slabs);
  std::iota(order.begin(), order.end(), 0);
  for (int round = 0; round < 12; ++round) {
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[static_cast<std::size_t>(draw.Whole(0, static_cast<int>(i) - 1))]);
    const double x = round % 3 * 0.7, index = round % 2 ? 1.5 : 1, sine = x / std::hypot(x, 1) / index;
    const double way = 0.3 / std::sqrt(1 - sine * sine);
    const std::string camera = "camera 0 7 0  " + Words(x) + " -1 0  0 0 -1  1e-7 0.01 100 ";
    RenderSettings s = round % 2 ? Whitted(2, 1) : Path(2, 1);
    s.trace.max_depth = 100;
    const R2::Color seen = project::Render(stage_of(order, index, camera), s).image.At(0, 0);
    for (const auto& [a, b] : {std::pair{seen.r, sum.r}, {seen.g, sum.g}, {seen.b, sum.b}})
      EXPECT_NEAR(a, std::exp(-b * way), 1e-6) << "round " << round;
  }
}

// Solids in solids refract as Snell's law says in arithmetic of 113 bits.

using ray::Lobe;

/// What a path that is refracted everywhere is like when nothing is left to be hit.
std::optional<R3::Ray> Refracted(const project::Stage& stage, const R3::Ray& from, const char* kind) {
  const auto accelerator = ray::FindAcceleratorKind(kind)->Make(stage.world, {.name = kind});
  const ray::Tracer tracer(stage.world, *accelerator, true);
  ray::TraceState state;
  state.Begin();
  R3::Ray ray = from;
  std::vector<ray::CameraSample> camera(1);
  camera[0].ray = from;
  std::vector<ray::ShadingPoint> points = tracer.CameraHits(camera, state);
  for (int i = 0; i < 100; ++i) {
    if (points.empty()) return ray;
    const auto direction = ray::Refraction(points[0]);
    if (!direction) return {};
    ray = ray::SpawnRay(points[0], *direction);
    ray::PathState path = ray::Extend(points[0], Lobe::transmission, {1, 1, 1}, {});
    const auto hit = tracer.Intersect(ray, path, state);
    if (!hit) return ray;
    std::vector<ray::ShadingPoint> next{tracer.PointAt(ray, path, *hit, state)};
    points.swap(next);
  }
  return {};
}

struct QuadRay {
  oracle::Vector origin, direction;
};

/// Snell's law; `n` is unit and against the direction, `eta` the index before over that behind.
oracle::Vector Snell(const oracle::Vector& d, const oracle::Vector& n, Quad eta) {
  const Quad cosine = -oracle::Dot(d, n), sine2 = eta * eta * (1 - cosine * cosine);
  return eta * d + (eta * cosine - oracle::Sqrt(1 - sine2)) * n;
}

/// Through a ball about the origin from outside, and what is inside of it, with `index` for each radius from the
/// largest.
QuadRay ThroughBalls(QuadRay ray, const std::vector<std::pair<double, double>>& balls) {
  Quad outside = 1;
  std::vector<Quad> indices{1};
  const auto cross = [&](double radius, bool enters, Quad eta) {
    const Quad a = oracle::Dot(ray.direction, ray.direction), b = oracle::Dot(ray.origin, ray.direction);
    const Quad c = oracle::Dot(ray.origin, ray.origin) - Quad(radius) * radius;
    const Quad root = oracle::Sqrt(b * b - a * c);
    const Quad t = (enters ? -b - root : -b + root) / a;
    ray.origin = ray.origin + t * ray.direction;
    const oracle::Vector n = (enters ? 1 / Quad(radius) : -1 / Quad(radius)) * ray.origin;
    ray.direction = Snell(ray.direction, n, eta);
  };
  for (const auto& [radius, index] : balls) cross(radius, true, outside / Quad(index)), outside = index;
  for (std::size_t i = balls.size(); i-- > 0;) {
    const Quad beyond = i == 0 ? Quad(1) : Quad(balls[i - 1].second);
    cross(balls[i].first, false, Quad(balls[i].second) / beyond);
  }
  return ray;
}

void ExpectOnLine(const R3::Ray& ray, const QuadRay& truth, const std::string& what) {
  const R3::Vector d{static_cast<double>(truth.direction.x), static_cast<double>(truth.direction.y),
                     static_cast<double>(truth.direction.z)};
  EXPECT_LT(Length(Unit(ray.direction) - d), 1e-11) << what;
  const R3::Point o{static_cast<double>(truth.origin.x), static_cast<double>(truth.origin.y),
                    static_cast<double>(truth.origin.z)};
  EXPECT_LT(Length(Cross(ray.origin - o, d)), 1e-9) << what;
}

TEST(Extremes, M6_BallsInBallsRefractAsSnellsLawSays) {
  // Water in glass, with ice in the water; the water again, listed first; then an air bubble between them.
  const std::string glass = Material(0, 0, 1, 0, 10, 1.5), water = Material(0, 0, 1, 0, 10, 1.33),
                    ice = Material(0, 0, 1, 0, 10, 1.31);
  const std::string priorities = "priority 0 1 priority 1 2 priority 2 3 ";
  const project::Stage stages[] = {
      StageOf(glass + water + ice + priorities + "sphere 0 0 0 0 2 sphere 1 0 0 0 1.5 sphere 2 0 0 0 0.7"),
      StageOf(glass + water + ice + priorities + "sphere 2 0 0 0 0.7 sphere 1 0 0 0 1.5 sphere 0 0 0 0 2"),
  };
  const std::vector<std::pair<double, double>> balls{{2, 1.5}, {1.5, 1.33}, {0.7, 1.31}};
  Draw draw(61);
  int through = 0;
  for (int i = 0; i < 400; ++i) {
    const R3::Point from = R3::Point{} + 5 * draw.Direction(),
                    to = R3::Point{} + draw.Between(0, 0.4) * draw.Direction();
    const R3::Ray ray{from, Unit(to - from)};
    const QuadRay truth = ThroughBalls({oracle::Of(ray.origin), oracle::Of(ray.direction)}, balls);
    for (const project::Stage& stage : stages)
      for (const char* kind : {"none", "bvh"}) {
        const auto end = Refracted(stage, ray, kind);
        ASSERT_TRUE(end);
        ExpectOnLine(*end, truth, std::to_string(i) + " by " + kind);
        ++through;
      }
  }
  EXPECT_EQ(through, 1600);
}

TEST(Extremes, M6_GlassBoundsWaterThatTouchesOrOverlapsIt) {
  // A wall of glass and water beyond it, as boxes: a ray shifts by what each layer refracts it.
  struct Layers {
    const char* name;
    double water_from;  // the wall is from 0 to 1
    double air;
  };
  for (const Layers& layers :
       {Layers{"touching", 1, 0}, Layers{"overlapping", 1 - 1e-3, 0}, Layers{"apart", 1.25, 0.25}})
    for (const bool is_water_first : {false, true}) {
      const std::string glass = "box 0 -50 0 -50  50 1 50 ",
                        water = "box 1 -50 " + Words(layers.water_from) + " -50  50 3 50 ";
      const project::Stage stage =
          StageOf(Material(0, 0, 1, 0, 10, 1.5) + Material(0, 0, 1, 0, 10, 1.33) + "priority 0 1 priority 1 0 " +
                  (is_water_first ? water + glass : glass + water));
      Draw draw(62);
      for (int i = 0; i < 100; ++i) {
        const R3::Ray ray{{0, -1, 0}, Unit(R3::Vector{draw.Between(-2, 2), 1, draw.Between(-2, 2)})};
        const Quad sx = ray.direction.x, sz = ray.direction.z;
        QuadRay truth{{0, 3, 0}, oracle::Of(ray.direction)};
        const auto layer = [&](Quad thick, Quad index) {
          const Quad x = sx / index, z = sz / index, y = oracle::Sqrt(1 - x * x - z * z);
          truth.origin.x += thick * x / y, truth.origin.z += thick * z / y;
        };
        layer(1, 1), layer(1, 1.5), layer(layers.air, 1), layer(2 - Quad(layers.air), 1.33);
        for (const char* kind : {"none", "bvh"}) {
          const auto end = Refracted(stage, ray, kind);
          ASSERT_TRUE(end);
          ExpectOnLine(*end, truth, std::string(layers.name) + " by " + kind);
        }
      }
    }
}

TEST(Extremes, M6_ACameraInsideNestedSolidsSeesTheirAbsorption) {
  // In tinted glass, in a ball of another tint: what is absorbed is that of both ways.
  const std::string materials =
      Material(0, 0, 1, 0) + Material(0, 0, 1, 0) + "absorb 0 0.1 0.2 0.3 absorb 1 0.4 0.1 0 ";
  for (const char* shapes : {"sphere 0 0 0 0 3 sphere 1 0 0 0 1 ", "sphere 1 0 0 0 1 sphere 0 0 0 0 3 "}) {
    const project::Stage stage =
        StageOf("camera 0 0.5 0  0 0 -1  0 1 0  1e-7 0.01 100 ambient 0 0 0 background 1 1 1 " + no_light + materials +
                shapes + "priority 1 1 ");
    const double inner = std::sqrt(0.75), outer = std::sqrt(8.75) - inner;
    for (const RenderSettings& s : {Whitted(2, 1), Path(2, 1)}) {
      const R2::Color seen = project::Render(stage, s).image.At(0, 0);
      EXPECT_NEAR(seen.r, std::exp(-0.4 * inner - 0.1 * outer), 1e-6) << shapes;
      EXPECT_NEAR(seen.g, std::exp(-0.1 * inner - 0.2 * outer), 1e-6) << shapes;
      EXPECT_NEAR(seen.b, std::exp(-0.3 * outer), 1e-6) << shapes;
    }
  }
}

// Where surfaces lie in one plane, the first that emits is seen, or else the first, from everywhere and by every
// accelerator.

TEST(Extremes, M7_OfSurfacesInOnePlaneTheFirstLampOrTheFirstIsSeen) {
  struct Poster {
    double low[2], high[2];
    bool emits;
    bool Holds(double x, double z, double margin) const {
      return x > low[0] - margin && x < high[0] + margin && z > low[1] - margin && z < high[1] + margin;
    }
  };
  std::uint64_t hits = 0, near_edges = 0;
  for (int number = 0; number < Count(12, 200); ++number) {
    Draw draw(static_cast<std::uint64_t>(number) + 700);
    const R3::Matrix turn = number % 3 ? draw.Rotation() : R3::Matrix{};
    std::string text = Material(0.5, 0, 0, 0) + Material(0, 0, 0, 4) + "begin 0";
    for (const auto& row : turn.m)
      for (const double x : row) text += " " + Words(x);
    text += " 0 0 0 1\n";
    std::vector<Poster> posters;
    for (int i = 0; i < draw.Whole(2, 40); ++i) {
      Poster p;
      for (const int axis : {0, 1})
        p.low[axis] = draw.Between(-1, 0.5), p.high[axis] = p.low[axis] + draw.Between(0.1, 0.6);
      p.emits = number % 2 == 0 && draw.Whole(0, 3) == 0;
      posters.push_back(p);
      const std::string a = Words(p.low[0]) + " 0.25 " + Words(p.low[1]) + " ",
                        b = Words(p.high[0]) + " 0.25 " + Words(p.low[1]) + " ",
                        c = Words(p.high[0]) + " 0.25 " + Words(p.high[1]) + " ",
                        d = Words(p.low[0]) + " 0.25 " + Words(p.high[1]) + " ";
      const std::string material = p.emits ? "1 " : "0 ";
      text += draw.Whole(0, 1) ? "quad " + material + a + b + c + d : "polygon " + material + "4 " + d + a + b + c;
    }
    const project::Stage stage = StageOf(text + " end");
    ASSERT_EQ(stage.world.Instances().size(), posters.size());
    for (const auto& way : accelerators::EveryWay()) {
      const auto accelerator = ray::FindAcceleratorKind(way.settings.name)->Make(stage.world, way.settings);
      ray::Workspace workspace;
      Draw aim(77);
      for (int i = 0; i < 400; ++i) {
        const double x = aim.Between(-1, 1), z = aim.Between(-1, 1);
        const R3::Point to{x, 0.25, z};
        R3::Point from = to + aim.Scale(-2, 2) * aim.Direction();
        if (i % 4 == 0) from.y = 0.25 + 0.02 * (from.y - 0.25);
        const R3::Ray ray{turn * from, turn * (to - from)};
        auto expected = std::ranges::find_if(posters, [&](const Poster& p) { return p.emits && p.Holds(x, z, 0); });
        if (expected == posters.end())
          expected = std::ranges::find_if(posters, [&](const Poster& p) { return p.Holds(x, z, 0); });
        if (std::ranges::any_of(posters,
                                [&](const Poster& p) { return p.Holds(x, z, 1e-9) != p.Holds(x, z, -1e-9); })) {
          ++near_edges;
          continue;
        }
        const auto hit = accelerator->Intersect(ray, workspace);
        ASSERT_EQ(hit.has_value(), expected != posters.end()) << way.name << ' ' << oracle::Hex(ray);
        if (!hit) continue;
        ++hits;
        ASSERT_EQ(hit->instance, static_cast<std::uint32_t>(expected - posters.begin()))
            << way.name << ' ' << number << ' ' << oracle::Hex(ray);
      }
    }
  }
  EXPECT_GT(hits, 10'000u);
  EXPECT_LT(near_edges, hits / 100);
}

TEST(Extremes, M7_TheFirstOfManyCoplanarSurfacesIsSeen) {
  std::string text = Material(0.5, 0, 0, 0) + Material(0, 0.5, 0.5, 0, 10, 1.5);
  for (int i = 0; i < 100'000; ++i)
    text += "tri " + std::to_string(i % 2) + " -1 0 -1  1 0 -1  0 0 " + Words(1 + 1e-9 * (i % 50'000)) + "\n";
  const project::Stage stage = StageOf(text);
  for (const char* kind : {"none", "graph", "grid", "octree", "bvh"}) {
    const auto accelerator = ray::FindAcceleratorKind(kind)->Make(stage.world, {.name = kind});
    ray::Workspace workspace;
    const auto hit = accelerator->Intersect({{0.1, 3, -0.2}, {0, -1, 0.1}}, workspace);
    ASSERT_TRUE(hit) << kind;
    EXPECT_EQ(hit->instance, 0u) << kind;
  }
}

}  // namespace
}  // namespace statistics
