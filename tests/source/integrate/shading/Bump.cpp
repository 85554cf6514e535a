#include "source/integrate/shading/Bump.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "R3/Warp.h"
#include "source/integrate/shading/ShadingPoint.h"
#include "tests/Project.h"

namespace ray {
namespace {

/// An image that rises from left to right by 1 over its width, `steps` texels wide.
std::shared_ptr<const Texture> Ramp(int steps) {
  R2::Image image(steps, 2);
  for (int x = 0; x < steps; ++x)
    for (int y = 0; y < 2; ++y) {
      const double height = (x + 0.5) / steps;
      image.Set(x, y, {height, height, height});
    }
  return std::make_shared<const Texture>(Texture{std::move(image)});
}

/// Traces single rays in a scene.
class Looking {
 public:
  explicit Looking(Scene scene)
      : stage_(std::move(scene)), accelerator_(FindAcceleratorKind("none")->Make(stage_.world, {})) {}

  std::optional<ShadingPoint> Along(const R3::Ray& ray) const {
    Workspace workspace;
    const auto hit = accelerator_->Intersect(ray, workspace);
    if (!hit) return {};
    return ShadingPointAt(stage_.world, ray, {}, *hit);
  }

 private:
  project::Stage stage_;
  std::unique_ptr<const Accelerator> accelerator_;
};

Scene SceneOf(const std::string& shape) {
  return project::FromText("material 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 0 " + shape);
}

Scene WithBump(Scene scene, std::shared_ptr<const Texture> bump, double height) {
  scene.materials.back().bump = std::move(bump);
  scene.materials.back().bump_height = height;
  return scene;
}

/// Returns the surface that a ray from straight above hits at (x, 1, z) on a box from -2 to 2, 1 high.
ShadingPoint SeenFromAbove(double height, double x, double z) {
  const Looking at(WithBump(SceneOf("box 0 -2 0 -2 2 1 2"), Ramp(64), height));
  ShadingPoint surface = *at.Along({{x, 5, z}, {0, -1, 0}});
  surface.material = nullptr;  // it is destroyed with the scene
  return surface;
}

// On the upper face u = 1 - (x + 2) / 4, so a slope of 1 over u falls by 1/4 per unit of length towards +x.
TEST(Bump, AnEvenSlopeTiltsTheNormalByItsGradient) {
  for (const double height : {0.5, -0.5, 0.01, 20.0})
    for (const double x : {-1.3, 0.2, 0.9}) {
      const ShadingPoint surface = SeenFromAbove(height, x, 0.4);
      const R3::Vector expected = Unit(R3::Vector{height / 4, 1, 0});
      EXPECT_LT(Length(surface.N - expected), 1e-7) << height << " at " << x;
    }
}

TEST(Bump, LeavesTheSurfaceUnchanged) {
  EXPECT_EQ(SeenFromAbove(3, 0.3, 0.4).at.position, SeenFromAbove(1e-9, 0.3, 0.4).at.position);
}

TEST(Bump, NearAnEdgeThereIsStillANormal) {
  const ShadingPoint surface = SeenFromAbove(0.5, 2 - 1e-9, 0.4);
  EXPECT_NEAR(Length(surface.N), 1, 1e-12);
}

/// An image whose luminance is 0.6 u + 0.3 v, except near its edges, where it repeats.
std::shared_ptr<const Texture> SlantedTexture() {
  constexpr int size = 64;
  R2::Image image(size, size);
  for (int x = 0; x < size; ++x)
    for (int y = 0; y < size; ++y) {
      const double height = (0.6 * (x + 0.5) + 0.3 * (y + 0.5)) / size;
      image.Set(x, y, {height, height, height});
    }
  return std::make_shared<const Texture>(Texture{std::move(image)});
}

/// Returns the normal of the surface displaced outward by `height` times that luminance, from the hits of rays slightly
/// to each side; std::nullopt if one of them hits nothing or is near an edge of the image.
std::optional<R3::Vector> NormalOfMovedSurface(const Looking& at, const ShadingPoint& place, double height,
                                               double step) {
  const R3::Vector n = AsVector(place.at.normal);
  const auto moved = [&](const R3::Vector& aside) -> std::optional<R3::Vector> {
    const auto beside = at.Along({place.at.position + step * aside + step * n, -n, 0, 2 * step, place.time});
    if (!beside) return {};
    const auto [u, v] = beside->at.uv;
    if (std::min({u, v, 1 - u, 1 - v}) < 0.05) return {};
    return beside->at.position - R3::Point{} + height * (0.6 * u + 0.3 * v) * AsVector(beside->at.normal);
  };
  const R3::Tangents tangents = R3::TangentsOf(n);
  const auto ahead = moved(tangents.first), behind = moved(-tangents.first), left = moved(tangents.second),
             right = moved(-tangents.second);
  if (!ahead || !behind || !left || !right) return {};
  const R3::Vector normal = Unit(Cross(*ahead - *behind, *left - *right));
  return Dot(normal, n) < 0 ? -normal : normal;
}

struct SizedShape {
  const char* text;
  double size;  // of the smallest of its curves and sides that rays hit
};

// Every shape, including long ones, in frames that stretch, shear, mirror and move them; the oracle uses only the hits
// of rays.
TEST(Bump, TheNormalIsThatOfTheDisplacedSurface) {
  for (const auto& [text, size] :
       {SizedShape{"sphere 0  0 0 0  2", 2},
        {"box 0  -1 -1 -1  1 1 1", 1},
        {"cylinder 0  0 0 0  1 2", 1},
        {"cylinder 0  0 0 0  1 1e5", 1},
        {"cylinder 0  0 0 -1e3  1e3 .01", .01},
        {"cone 0  0 0 0  1.5 2", .5},
        {"cone 0  0 0 0  1 1e5", .5},
        {"torus 0  0 0 0  1 .4", .4},
        {"torus 0  0 0 -1e3  1e3 .4", .4},
        {"plane 0  0 0 0  1 2 3", 1},
        {"disc 0  0 0 0  1 2 3  2", 2},
        {"tri 0  -5 -5 0  5 -5 0  0 9 1", 5},
        {"tri 0  -5e4 -.1 0  5e4 -.1 0  1e4 .1 0", .2},
        {"quad 0  -3 -2 0  3 -2 0  3 2 0  -3 2 0", 4},
        {"begin -1  2 0 0 0  0 .5 0 0  .3 0 -1 0  0 0 0 1 sphere 0  0 0 0  1 end", .5},
        {"begin -1  1 0 0 0  0 1e-3 0 0  0 0 1 0  0 0 0 1 sphere 0  0 0 0  1 end", 1e-3},
        {"begin -1  1 .5 0 1  0 -1 0 0  0 0 3 0  0 0 0 1 motion 1 2 3 cone 0  0 0 0  1 2 end", .5},
        {"begin -1  -1 0 0 0  .2 1 0 0  0 0 1 0  0 0 0 1 tri 0  -5 -5 0  5 -5 0  0 9 1 end", 5}}) {
    const double height = 1e-3 * size;
    const Looking at(WithBump(SceneOf(text), SlantedTexture(), height));
    int compared = 0;
    for (int i = 0; i < 400; ++i) {
      const double a = 0.37 * i, b = std::sin(1.7 * i), c = 1e-3 * (i % 20);
      const R3::Point target{b * size * std::cos(a), b * size * std::sin(a), c * size};
      const R3::Point origin{target.x + 3 * size * std::sin(a), target.y + 2 * size * std::cos(a), 5 * size};
      auto place = at.Along({origin, target - origin, 0, R3::infinity, 0.25});
      if (!place) continue;
      const auto expected = NormalOfMovedSurface(at, *place, height, 1e-4 * size);
      if (!expected) continue;
      ++compared;
      const R3::Vector tilt = place->N - place->Outward(), right = *expected - AsVector(place->at.normal);
      // Second order in the height and in the step.
      EXPECT_LT(Length((place->entering ? 1 : -1) * tilt - right), 5e-3 * Length(right)) << text << " " << i;
    }
    EXPECT_GT(compared, 10) << text;
  }
}

/// A square from -1 to 1 in z = 0 on which the texture repeats that many times, or both coordinates run along x alone.
std::shared_ptr<const R3::Mesh> Tiled(double times, double v_times) {
  R3::MeshData data;
  data.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  data.triangles = {{0, 1, 2}, {0, 2, 3}};
  for (const R3::Point& p : data.positions)
    data.uvs.push_back({times * (p.x + 1) / 2, v_times == 0 ? times * (p.x + 1) / 4 : v_times * (p.y + 1) / 2});
  return std::make_shared<const R3::Mesh>(std::move(data));
}

Scene SceneOf(std::shared_ptr<const R3::Mesh> mesh) {
  Scene scene = SceneOf("");
  scene.root.children.emplace_back();
  scene.root.children.back().shape = std::move(mesh);
  scene.root.children.back().material = static_cast<int>(scene.materials.size()) - 1;
  return scene;
}

// At any place of a ramp, its slope is the number of repetitions over the width of 2.
TEST(Bump, SlopesAreRightForOneRepetitionAndForAMillion) {
  for (const double times : {1.0, 3.0, 1024.0, 1450.0, 2896.0, 1e5, 1e6}) {
    const Looking at(WithBump(SceneOf(Tiled(times, times)), Ramp(64), 0.5 / times));
    const double tile = 2 / times;
    for (const double share : {0.02, 0.3, 0.51, 0.97}) {
      const double x = std::floor(0.37 * times) * tile + share * tile - 1;
      const auto seen = at.Along({{x, 0.1234, 3}, {0, 0, -1}});
      ASSERT_TRUE(seen);
      EXPECT_LT(Length(seen->N - Unit(R3::Vector{-0.25, 0, 1})), 1e-8) << times << " at " << share;
    }
  }
}

// dp/dv does not exist then, but the slope along x still follows from both coordinates.
TEST(Bump, BothCoordinatesMayRunTheSameWay) {
  const Looking at(WithBump(SceneOf(Tiled(1, 0)), SlantedTexture(), 1));
  const auto seen = at.Along({{0.2, 0.3, 3}, {0, 0, -1}});
  EXPECT_LT(Length(seen->N - Unit(R3::Vector{-(0.6 / 2 + 0.3 / 4), 0, 1})), 1e-6);
}

TEST(Bump, SmoothMeshesTiltTheirNormalsByFaceSlopes) {
  R3::MeshData data = Tiled(1, 1)->Data();
  const R3::Vector leaning = Unit(R3::Vector{0.1, -0.2, 1});
  for (std::size_t i = 0; i < data.positions.size(); ++i) data.normals.push_back(AsNormal(leaning));
  const Looking at(WithBump(SceneOf(std::make_shared<const R3::Mesh>(std::move(data), true)), Ramp(64), 0.5));
  const auto seen = at.Along({{0.2, 0.3, 3}, {0, 0, -1}});
  EXPECT_LT(Length(seen->N - Unit(leaning - R3::Vector{0.25, 0, 0})), 1e-8);
}

/// A ball's pole and a cone's apex that face +z, where dp/du has no length and u no direction.
constexpr std::array with_a_pole{"sphere 0  0 0 0  1",
                                 "begin -1  1 0 0 0  0 0 -1 0  0 1 0 0  0 0 0 1 cone 0  0 0 0  1 1 end"};

TEST(Bump, AtAPoleAndAnApexTheNormalStays) {
  for (const char* shape : with_a_pole) {
    const Looking at(WithBump(SceneOf(shape), SlantedTexture(), 0.1));
    const auto seen = at.Along({{0, 0, 3}, {0, 0, -1}});
    ASSERT_TRUE(seen) << shape;
    EXPECT_EQ(seen->N, (R3::Vector{0, 0, 1})) << shape;
  }
}

TEST(Bump, TextureCoordinatesThatDoNotChangeTiltNothing) {
  R3::MeshData data = Tiled(1, 1)->Data();
  for (R2::Point& uv : data.uvs) uv = {0.3, 0.6};
  const Looking at(WithBump(SceneOf(std::make_shared<const R3::Mesh>(std::move(data))), SlantedTexture(), 0.1));
  EXPECT_EQ(at.Along({{0.2, 0.3, 3}, {0, 0, -1}})->N, (R3::Vector{0, 0, 1}));
}

/// A normal map of one color.
std::shared_ptr<const Texture> Tilted(const R3::Vector& n) {
  R2::Image image(2, 2);
  for (int i = 0; i < 4; ++i) image.Set(i % 2, i / 2, {(n.x + 1) / 2, (n.y + 1) / 2, (n.z + 1) / 2});
  return std::make_shared<const Texture>(Texture{std::move(image)});
}

Scene WithMap(Scene scene, const R3::Vector& map) {
  scene.materials.back().normal_map = Tilted(map);
  return scene;
}

struct MappedPlace {
  R3::Vector N, outward;
  R2::Point uv;
  R3::Point position;
};

/// Returns the surface that a ray hits in a scene whose last material has that map.
std::optional<MappedPlace> LookAtMap(const std::string& shape, const R3::Ray& ray, const R3::Vector& map) {
  const auto s = Looking(WithMap(SceneOf(shape), map)).Along(ray);
  if (!s) return {};
  return MappedPlace{s->N, AsVector(s->at.normal), s->at.uv, s->at.position};
}

// On the upper face of a box u falls towards +x.
TEST(NormalMap, TiltsTheNormalAlongUAndV) {
  const R3::Ray down{{0.2, 5, 0.4}, {0, -1, 0}};
  const char* box = "box 0 -2 0 -2 2 1 2";
  EXPECT_LT(Length(LookAtMap(box, down, {0, 0, 1})->N - R3::Vector{0, 1, 0}), 1e-7);
  const R3::Vector along_u = LookAtMap(box, down, {0.6, 0, 0.8})->N, along_v = LookAtMap(box, down, {0, 0.6, 0.8})->N;
  EXPECT_LT(Length(along_u - R3::Vector{-0.6, 0.8, 0}), 1e-6);
  EXPECT_NEAR(along_v.y, 0.8, 1e-6);
  EXPECT_NEAR(std::abs(along_v.z), 0.6, 1e-6);
}

// On every shape, in the direction of a red tilt u is greater and v equal; for green vice versa.
TEST(NormalMap, OfEveryShapeLeansToWhereUAndVGrow) {
  for (const char* shape :
       {"sphere 0  0 0 0  1", "box 0  -1 -1 -1  1 1 1", "cylinder 0  0 0 0  1 2", "cone 0  0 0 0  1.5 2",
        "torus 0  0 0 0  1 .4", "plane 0  0 0 0  1 2 3", "disc 0  0 0 0  1 2 3  2", "tri 0  -5 -5 0  5 -5 0  0 9 1",
        "begin -1  2 0 0 0  0 .5 0 0  .3 0 -1 0  0 0 0 1 sphere 0  0 0 0  1 end"}) {
    const auto ray_at = [](double x, double y) { return R3::Ray{{4 + x, 3 + y, 5}, {-4 + 0.31, -3 + 0.27, -5 + 0.1}}; };
    const auto flat = LookAtMap(shape, ray_at(0, 0), {0, 0, 1});
    ASSERT_TRUE(flat) << shape;
    for (const R3::Vector& map : {R3::Vector{0.6, 0, 0.8}, R3::Vector{0, 0.6, 0.8}}) {
      const R3::Vector lean = Unit(LookAtMap(shape, ray_at(0, 0), map)->N - 0.8 * flat->N);
      constexpr double step = 1e-4;
      const R3::Point above = flat->position + step * lean + step * flat->outward;
      const auto beside = LookAtMap(shape, {above, -flat->outward}, {0, 0, 1});
      ASSERT_TRUE(beside) << shape;
      const double du = beside->uv.x - flat->uv.x, dv = beside->uv.y - flat->uv.y;
      EXPECT_GT(map.x > 0 ? du : dv, 0) << shape;
      EXPECT_LT(std::abs(map.x > 0 ? dv : du), 0.02 * std::abs(map.x > 0 ? du : dv)) << shape;
    }
  }
}

TEST(NormalMap, IsTheSameForOneRepetitionAndForAMillion) {
  for (const double times : {1.0, 3.0, 1450.0, 2000.0, 1e5, 1e6}) {
    const auto seen =
        Looking(WithMap(SceneOf(Tiled(times, 2 * times)), {0.48, 0.36, 0.8})).Along({{.37, .41, 3}, {0, 0, -1}});
    EXPECT_LT(Length(seen->N - R3::Vector{0.48, 0.36, 0.8}), 1e-7) << times;
  }
}

// If a texture is seen from behind, as on a mirrored half of a model, green still points to increasing v.
TEST(NormalMap, LeansToWhereVGrowsOnAMirroredTexture) {
  const auto seen = Looking(WithMap(SceneOf(Tiled(1, -2)), {0.48, 0.36, 0.8})).Along({{.37, .41, 3}, {0, 0, -1}});
  EXPECT_LT(Length(seen->N - R3::Vector{0.48, -0.36, 0.8}), 1e-7);
}

TEST(NormalMap, AtAPoleAndAnApexTheNormalStays) {
  for (const char* shape : with_a_pole) {
    const auto seen = LookAtMap(shape, {{0, 0, 3}, {0, 0, -1}}, {0.48, 0.36, 0.8});
    ASSERT_TRUE(seen) << shape;
    EXPECT_EQ(seen->N, (R3::Vector{0, 0, 1})) << shape;
  }
}

TEST(NormalMap, FromTheInsideIsTheOutsidesTurnedRound) {
  const R3::Vector map{0.48, 0.36, 0.8};
  const auto outside = LookAtMap("sphere 0  0 0 0  1", {{5, 1, 2}, {-5, -0.9, -1.9}}, map);
  const R3::Vector way = outside->position - R3::Point{};
  const auto inside = LookAtMap("sphere 0  0 0 0  1", {{0, 0, 0}, way}, map);
  EXPECT_LT(Length(outside->N + inside->N), 1e-5);
}

TEST(NormalMap, OfBlackHasNoEffect) {
  const auto seen = LookAtMap("sphere 0  0 0 0  1", {{5, 1, 2}, {-5, -0.9, -1.9}}, {-1, -1, -1});
  EXPECT_LT(Length(seen->N - seen->outward), 1e-12);
}

}  // namespace
}  // namespace ray
