// What every shape promises, whatever it is: a new line in shapes.def is tested here the day it is written.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "R3/Implicit.h"
#include "R3/ShapeKind.h"
#include "tests/BoundedShapes.h"
#include "tests/Draw.h"
#include "tests/Quad.h"

namespace {

struct Subject {
  const char* name;
  std::unique_ptr<const R3::Shape> shape;
};

/// An example of every kind, and of what a formula and not numbers make.
std::vector<Subject> EveryShape() {
  std::vector<Subject> subjects;
  for (const auto* kind : BoundedShapeKinds()) subjects.push_back({kind->name, kind->make(kind->example)});
  const R3::Expression formula("(x - 0.25)^2 + (y + 0.5)^2 + 1.5 z^2 - 1 - 0.2 sin(2 x)");
  subjects.push_back({"implicit", std::make_unique<R3::Implicit>(formula, R3::Box{{-1.5, -2, -1.5}, {2, 0.25, 1}})});
  return subjects;
}

R3::Ray RayTowards(Draw& draw, const R3::Shape& shape) {
  const R3::Box box = Bounds(shape);
  const R3::Vector size = box.Size();
  const R3::Point origin = box.Center() + draw.Scale(0, 3) * box.Radius() * draw.Direction();
  const R3::Point target =
      box.low + R3::Vector{size.x * draw.Between(0, 1), size.y * draw.Between(0, 1), size.z * draw.Between(0, 1)};
  return {origin, draw.Scale(-3, 3) * (target - origin)};
}

/// Calls check(subject, ray, hit) for many hits of every shape.
template <typename Check>
void ForManyHits(std::uint64_t seed, const Check& check) {
  for (const Subject& subject : EveryShape()) {
    Draw draw(seed);
    int hits = 0;
    for (int i = 0; i < Count(10'000, 1'000'000); ++i) {
      const R3::Ray ray = RayTowards(draw, *subject.shape);
      if (const auto hit = subject.shape->Intersect(ray, 0)) {
        ++hits;
        check(subject, ray, *hit);
      }
    }
    EXPECT_GT(hits, 1000) << subject.name << ": its example is hardly ever hit";
  }
}

TEST(EveryShape, IsNeverHitOutsideItsBounds) {
  ForManyHits(701, [](const Subject& s, const R3::Ray& ray, const R3::Hit& hit) {
    const R3::Box box = Bounds(*s.shape);
    const auto at = s.shape->At(ray, hit, 0);
    EXPECT_LE(box.low.x - at.error.x, at.position.x) << s.name << ' ' << oracle::Hex(ray);
    EXPECT_LE(box.low.y - at.error.y, at.position.y) << s.name << ' ' << oracle::Hex(ray);
    EXPECT_LE(box.low.z - at.error.z, at.position.z) << s.name << ' ' << oracle::Hex(ray);
    EXPECT_GE(box.high.x + at.error.x, at.position.x) << s.name << ' ' << oracle::Hex(ray);
    EXPECT_GE(box.high.y + at.error.y, at.position.y) << s.name << ' ' << oracle::Hex(ray);
    EXPECT_GE(box.high.z + at.error.z, at.position.z) << s.name << ' ' << oracle::Hex(ray);
  });
}

TEST(EveryShape, ReportsPositionsOnTheRayWithinRounding) {
  ForManyHits(702, [](const Subject& s, const R3::Ray& ray, const R3::Hit& hit) {
    // 32 u (D + size) is what Shape::Intersect promises; the position is pushed at most that far back to the surface.
    const R3::Box box = Bounds(*s.shape);
    const double D = Length(ray.origin - box.Center()) + Length(FromOrigin(box.Center())) + 2 * box.Radius();
    const auto p = oracle::Of(ray.origin) + Quad(hit.t) * oracle::Of(ray.direction);
    const auto at = s.shape->At(ray, hit, 0);
    EXPECT_LE(oracle::Double(oracle::Length(p - oracle::Of(at.position))), 40 * R3::unit_roundoff * D)
        << s.name << ' ' << oracle::Hex(ray);
  });
}

TEST(EveryShape, HasUnitNormalsThatFaceOutward) {
  ForManyHits(703, [](const Subject& s, const R3::Ray& ray, const R3::Hit& hit) {
    const auto at = s.shape->At(ray, hit, 0);
    EXPECT_NEAR(Length(AsVector(at.normal)), 1, 4 * R3::unit_roundoff) << s.name;
    if (!s.shape->IsSolid()) return;
    const double d = Length(ray.direction);
    // The origin is outside, so the first hit enters and the next one leaves.
    EXPECT_LE(Dot(at.normal, ray.direction), 1e-6 * d) << s.name << ' ' << oracle::Hex(ray);
    const auto second = s.shape->Intersect({ray.origin, ray.direction, hit.t}, 0);
    EXPECT_TRUE(!second || Dot(s.shape->At(ray, *second, 0).normal, ray.direction) >= -1e-6 * d) << s.name;
  });
}

TEST(EveryShape, HasNormalsPerpendicularToTheSurface) {
  // Two neighboring rays hit neighboring points of the same part; the step between them lies in the tangent plane up
  // to the curvature, so its share along the normal shrinks with the step. Steps of 1e-7 of the size leave 1e-4 where
  // the curvature is 1e-3 of the size, as near as a million rays come to a cone's apex.
  ForManyHits(704, [](const Subject& s, const R3::Ray& ray, const R3::Hit& hit) {
    const auto at = s.shape->At(ray, hit, 0);
    if (std::abs(Dot(at.normal, Unit(ray.direction))) < 0.2) return;
    const R3::Vector n = AsVector(at.normal);
    const R3::Vector across = Unit(Cross(n, std::abs(n.x) < 0.5 ? R3::Vector{1, 0, 0} : R3::Vector{0, 1, 0}));
    const double step = 1e-7 * Bounds(*s.shape).Radius();
    const R3::Ray beside{ray.origin, (at.position + step * across) - ray.origin};
    const auto other = s.shape->Intersect(beside, 0);
    if (!other || other->part != hit.part) return;
    const R3::Vector moved = s.shape->At(beside, *other, 0).position - at.position;
    if (Length(moved) > 20 * step || Length(moved) < step / 20) return;
    EXPECT_LE(std::abs(Dot(n, moved)) / Length(moved), 1e-3) << s.name << ' ' << oracle::Hex(ray);
  });
}

TEST(EveryShape, NarrowingTheRayDropsCrossingsButNeverChangesThem) {
  ForManyHits(705, [](const Subject& s, const R3::Ray& ray, const R3::Hit& hit) {
    const auto same = s.shape->Intersect({ray.origin, ray.direction, hit.t / 2, R3::NextUp(hit.t)}, 0);
    ASSERT_TRUE(same) << s.name << ' ' << oracle::Hex(ray);
    EXPECT_EQ(same->t, hit.t);
    EXPECT_EQ(same->part, hit.part);
    EXPECT_FALSE(s.shape->Intersect({ray.origin, ray.direction, 0, hit.t}, 0)) << s.name;
    const auto next = s.shape->Intersect({ray.origin, ray.direction, hit.t}, 0);
    EXPECT_TRUE(!next || next->t > hit.t) << s.name;
  });
}

TEST(EveryShape, HasTheCrossingsThatIntersectFindsOneByOne) {
  Draw draw(707);
  ForManyHits(706, [&](const Subject& s, const R3::Ray& ray, const R3::Hit& hit) {
    R3::Ray rest = ray;
    rest.t_min = draw.Whole(0, 1) == 0 ? hit.t : draw.Between(-4, 1) * hit.t;
    if (draw.Whole(0, 3) == 0) rest.t_max = draw.Between(1, 4) * hit.t;
    const R3::Crossings all = s.shape->CrossingsAlong(rest, 0);
    for (std::size_t i = 0; i < all.count; ++i) {
      const auto next = s.shape->Intersect(rest, 0);
      ASSERT_TRUE(next) << s.name << ' ' << i;
      EXPECT_EQ(all.hits[i].t, next->t) << s.name;
      EXPECT_EQ(all.hits[i].part, next->part) << s.name;
      rest.t_min = next->t;
    }
    if (!all.may_have_more) {
      EXPECT_FALSE(s.shape->Intersect(rest, 0)) << s.name;
    }
  });
}

TEST(EveryShape, HasThePlacesOfItsHitsWithoutTextures) {
  ForManyHits(708, [](const Subject& s, const R3::Ray& ray, const R3::Hit& hit) {
    const R3::Intersection at = s.shape->At(ray, hit, 0), place = s.shape->PlaceAt(ray, hit, 0);
    EXPECT_EQ(place.position, at.position) << s.name;
    EXPECT_EQ(AsVector(place.normal), AsVector(at.normal)) << s.name;
    EXPECT_EQ(AsVector(place.shading_normal), AsVector(at.shading_normal)) << s.name;
    EXPECT_EQ(place.error, at.error) << s.name;
  });
}

TEST(EveryShape, IsMissedByRaysThatAreNoRays) {
  const double nan = std::nan("");
  for (const Subject& s : EveryShape()) {
    const R3::Point origin = Bounds(*s.shape).Center() + R3::Vector{0, 0, 10};
    EXPECT_FALSE(s.shape->Intersect({origin, {0, 0, 0}}, 0)) << s.name;
    EXPECT_FALSE(s.shape->Intersect({origin, {nan, 0, -1}}, 0)) << s.name;
    EXPECT_FALSE(s.shape->Intersect({origin, {0, nan, -1}}, 0)) << s.name;
    EXPECT_FALSE(s.shape->Intersect({origin, {0, 0, nan}}, 0)) << s.name;
    EXPECT_FALSE(s.shape->Intersect({{nan, origin.y, origin.z}, {0, 0, -1}}, 0)) << s.name;
    EXPECT_FALSE(s.shape->Intersect({{origin.x, nan, origin.z}, {0, 0, -1}}, 0)) << s.name;
    EXPECT_FALSE(s.shape->Intersect({{origin.x, origin.y, nan}, {0, 0, -1}}, 0)) << s.name;
  }
}

TEST(EveryShape, HasTextureCoordinatesBetweenZeroAndOne) {
  ForManyHits(706, [](const Subject& s, const R3::Ray& ray, const R3::Hit& hit) {
    const R2::Point uv = s.shape->At(ray, hit, 0).uv;
    constexpr double slack = 1e-12;  // clamped or wrapped when a texture is looked up
    EXPECT_TRUE(uv.x >= -slack && uv.x <= 1 + slack && uv.y >= -slack && uv.y <= 1 + slack) << s.name;
  });
}

TEST(EveryShape, HasTextureCoordinatesThatRunAsItsUvTangentsSay) {
  ForManyHits(707, [](const Subject& s, const R3::Ray& ray, const R3::Hit& hit) {
    const auto at = s.shape->At(ray, hit, 0);
    const R3::UvTangents uv = s.shape->UvTangentsAt(ray, hit, 0);
    const R3::Vector n = AsVector(at.normal);
    // Tangents of less than a hundredth of the shape's size are beside a pole or an apex, where curves are short.
    const double size = Bounds(*s.shape).Radius(), step = 1e-6 * size;
    for (const auto& [tangent, gain] : {std::pair(uv.first, uv.gain_first), std::pair(uv.second, uv.gain_second)}) {
      const double length = Length(tangent);
      if (length < 1e-2 * size) continue;
      EXPECT_LE(std::abs(Dot(n, tangent)), 1e-14 * length) << s.name;
      const R3::Ray down{at.position + step / length * tangent + step * n, -n, 0, 2 * step};
      const auto beside = s.shape->Intersect(down, 0);
      if (!beside || beside->part != hit.part) continue;
      const R2::Vector found = s.shape->At(down, *beside, 0).uv - at.uv, told = step / length * gain;
      const auto over_seam = [](double difference) { return difference - std::round(difference); };
      EXPECT_NEAR(over_seam(found.x), told.x, 1e-9) << s.name << ' ' << oracle::Hex(ray);
      EXPECT_NEAR(over_seam(found.y), told.y, 1e-9) << s.name << ' ' << oracle::Hex(ray);
    }
  });
}

TEST(EveryShape, OfNoSizeIsNeverHit) {
  for (const auto& [name, arguments] :
       std::vector<std::pair<const char*, std::vector<double>>>{{"sphere", {0, 0, 0, 0}},
                                                                {"cylinder", {0, 0, 0, 0, 1}},
                                                                {"cylinder", {0, 0, 0, 1, 0}},
                                                                {"cone", {0, 0, 0, 0, 1}},
                                                                {"cone", {0, 0, 0, 1, 0}}}) {
    const auto shape = R3::MakeShape(name, arguments);
    EXPECT_TRUE(shape->IsDegenerate()) << name;
    for (const R3::Vector d : {R3::Vector{0, 0, -1}, R3::Vector{0, -1, 0}, R3::Vector{-1, -1, -1}})
      EXPECT_FALSE(shape->Intersect({R3::Point{} - 3 * d, d}, 0)) << name;
  }
}

using Corners = std::array<R3::Point, 3>;

/// The triangles that a shape is drawn with, and the normal that is meant at each corner.
struct Facet {
  Corners corners;
  std::array<R3::Vector, 3> normals;
  R3::Vector front;  // unit
};

std::vector<Facet> Facets(const R3::MeshData& data) {
  std::vector<Facet> facets;
  for (const auto& t : data.triangles) {
    Facet facet{{data.positions[t[0]], data.positions[t[1]], data.positions[t[2]]}, {}, {}};
    const auto& c = facet.corners;
    facet.front = Unit(Cross(c[1] - c[0], c[2] - c[0]));
    for (std::size_t i = 0; i < 3; ++i)
      facet.normals[i] = data.normals.empty() ? facet.front : AsVector(data.normals[t[i]]);
    facets.push_back(facet);
  }
  return facets;
}

R3::Point Middle(const Corners& c) {
  return R3::Point{} + (FromOrigin(c[0]) + FromOrigin(c[1]) + FromOrigin(c[2])) / 3;
}

/// The crossing nearest to `p` on the line through it along `front`, at most `reach` away, of those that face along.
std::optional<R3::Intersection> Nearest(const R3::Shape& shape, const R3::Point& p, const R3::Vector& front,
                                        double reach) {
  std::optional<R3::Intersection> nearest;
  R3::Ray ray{p + reach * front, -front, 0, 2 * reach};
  while (const auto hit = shape.Intersect(ray, 0)) {
    const auto at = shape.At(ray, *hit, 0);
    if (Dot(at.normal, front) > 0 && (!nearest || Length(at.position - p) < Length(nearest->position - p)))
      nearest = at;
    ray.t_min = hit->t;
  }
  return nearest;
}

constexpr int finenesses[] = {3, 4, 7, 12, 40};

/// Calls check(shape, data) for the triangles of every shape, and for those that it would have by rays alone.
template <typename Check>
void ForEveryTessellation(const Check& check) {
  for (const Subject& s : EveryShape())
    for (const int fineness : finenesses) {
      const testing::ScopedTrace what(__FILE__, __LINE__, s.name + (' ' + std::to_string(fineness)));
      check(*s.shape, s.shape->Tessellate(fineness));
      if (fineness < 12) continue;  // there the same
      const testing::ScopedTrace how(__FILE__, __LINE__, "by rays");
      check(*s.shape, s.shape->R3::Shape::Tessellate(fineness));
    }
}

TEST(EveryShape, IsDrawnWithCornersOnItsSurface) {
  // Else the picture that one walks through, and the rays drawn into it, would not be of the same scene. Seen from just
  // beside the corner, because a ray at a rim itself may miss.
  ForEveryTessellation([](const R3::Shape& shape, const R3::MeshData& data) {
    const double size = Bounds(shape).Radius();
    for (const Facet& facet : Facets(data))
      for (std::size_t i = 0; i < 3; ++i) {
        const R3::Point corner = facet.corners[i], beside = corner + 1e-6 * (Middle(facet.corners) - corner);
        const auto is_near = [&](const R3::Vector& way) {
          const auto at = Nearest(shape, beside, way, 1e-3 * size);
          return at && Length(at->position - corner) <= 4e-6 * size;
        };
        // What cuts off an edge is seen best along an axis.
        const R3::Vector ways[]{facet.normals[i], facet.front, {1, 0, 0}, {-1, 0, 0},
                                {0, 1, 0},        {0, -1, 0},  {0, 0, 1}, {0, 0, -1}};
        EXPECT_TRUE(std::any_of(std::begin(ways), std::end(ways), is_near)) << corner.x << ' ' << corner.y;
      }
  });
}

TEST(EveryShape, IsDrawnWithTheNormalsOfItsHits) {
  for (const Subject& s : EveryShape())
    for (const Facet& facet : Facets(s.shape->Tessellate(40)))
      for (std::size_t i = 0; i < 3; ++i) {
        const R3::Point corner = facet.corners[i], beside = corner + 1e-6 * (Middle(facet.corners) - corner);
        const auto at = Nearest(*s.shape, beside, facet.normals[i], 1e-3 * Bounds(*s.shape).Radius());
        ASSERT_TRUE(at) << s.name;
        // At a cone's apex it is meant for a column of triangles, half of one away.
        EXPECT_GT(Dot(at->normal, facet.normals[i]), 0.99) << s.name;
      }
}

TEST(EveryShape, IsDrawnWithFrontsOutside) {
  ForEveryTessellation([](const R3::Shape& shape, const R3::MeshData& data) {
    const double size = Bounds(shape).Radius();
    EXPECT_FALSE(data.triangles.empty());
    for (const Facet& facet : Facets(data)) {
      const auto at = Nearest(shape, Middle(facet.corners), facet.front, size);
      ASSERT_TRUE(at);
      EXPECT_GT(Dot(at->normal, facet.front), 0.4);
      for (const R3::Vector& normal : facet.normals) {
        EXPECT_NEAR(Length(normal), 1, 1e-12);
        EXPECT_GT(Dot(normal, facet.front), 0.4);
      }
    }
  });
}

TEST(EveryShape, ThatIsSolidIsDrawnWithoutHoles) {
  ForEveryTessellation([](const R3::Shape& shape, const R3::MeshData& data) {
    if (!shape.IsSolid()) return;
    using Place = std::array<double, 3>;
    std::map<std::pair<Place, Place>, int> edges;
    const auto place = [](const R3::Point& p) { return Place{p.x, p.y, p.z}; };
    for (const Facet& facet : Facets(data))
      for (std::size_t i = 0; i < 3; ++i) ++edges[{place(facet.corners[i]), place(facet.corners[(i + 1) % 3])}];
    for (const auto& [edge, count] : edges) {
      EXPECT_EQ(count, 1);
      EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
  });
}

/// The volume that rays along z are inside of, on a grid that shares no shape's symmetry.
double Volume(const R3::Shape& shape) {
  constexpr int lines = 100;
  const R3::Box box = Bounds(shape);
  const R3::Vector size = box.Size();
  double sum = 0;
  for (int i = 0; i < lines; ++i)
    for (int k = 0; k < lines; ++k) {
      R3::Ray ray{box.low + R3::Vector{(i + 0.37) / lines * size.x, (k + 0.37) / lines * size.y, -size.z}, {0, 0, 1}};
      while (const auto hit = shape.Intersect(ray, 0)) {
        sum += std::copysign(hit->t, shape.At(ray, *hit, 0).normal.z);
        ray.t_min = hit->t;
      }
    }
  return sum * size.x * size.y / (lines * lines);
}

TEST(EveryShape, ThatIsSolidIsDrawnWithItsVolume) {
  for (const Subject& s : EveryShape())
    for (const auto& data : {s.shape->Tessellate(64), s.shape->R3::Shape::Tessellate(64)}) {
      if (!s.shape->IsSolid()) continue;
      double volume = 0;  // by the divergence theorem
      for (const Facet& facet : Facets(data)) {
        const auto& c = facet.corners;
        volume += Dot(FromOrigin(c[0]), Cross(FromOrigin(c[1]), FromOrigin(c[2]))) / 6;
      }
      EXPECT_NEAR(volume / Volume(*s.shape), 1, 0.04) << s.name;
    }
}

TEST(EveryShape, IsDrawnWithNoMoreTrianglesThanAskedFor) {
  for (const Subject& s : EveryShape())
    for (const int fineness : finenesses) {
      const auto most = [&](int least) { return static_cast<std::size_t>(std::max(least, fineness * fineness)); };
      // Shapes that say how they are drawn need few.
      const bool says_how = std::set<std::string>{"sphere", "box", "cylinder", "cone", "tri"}.contains(s.name);
      EXPECT_LE(s.shape->Tessellate(fineness).triangles.size(), most(says_how ? 12 : 1000)) << s.name;
      EXPECT_LE(s.shape->R3::Shape::Tessellate(fineness).triangles.size(), most(1000)) << s.name;
    }
}

TEST(EveryShape, IsDrawnWithTheTextureCoordinatesOfItsHits) {
  for (const Subject& s : EveryShape()) {
    const R3::MeshData data = s.shape->Tessellate(40);
    ASSERT_EQ(data.uvs.size(), data.positions.size()) << s.name;
    const std::vector<Facet> facets = Facets(data);
    // In the middle of a triangle, where its corners' mean is near enough: a step of 1/40, less bending. Coordinates
    // that wrap around run on beyond 0 and 1.
    const auto off = [](double a, double b) { return std::abs(a - b - std::round(a - b)); };
    for (std::size_t i = 0; i < data.triangles.size(); ++i) {
      const auto& t = data.triangles[i];
      const auto at = Nearest(*s.shape, Middle(facets[i].corners), facets[i].front, Bounds(*s.shape).Radius());
      ASSERT_TRUE(at);
      EXPECT_LE(off(at->uv.x, (data.uvs[t[0]].x + data.uvs[t[1]].x + data.uvs[t[2]].x) / 3), 0.02) << s.name;
      EXPECT_LE(off(at->uv.y, (data.uvs[t[0]].y + data.uvs[t[1]].y + data.uvs[t[2]].y) / 3), 0.02) << s.name;
    }
  }
}

TEST(EveryShape, OfNoSizeIsDrawnWithNothing) {
  for (const R3::ShapeKind* kind : BoundedShapeKinds()) {
    std::unique_ptr<const R3::Shape> shape;
    try {
      shape = kind->make(std::vector<double>(kind->arguments.size()));
    } catch (const R3::ArgumentError&) {
      continue;  // what has a direction cannot be made without one
    }
    EXPECT_TRUE(shape->Tessellate(12).triangles.empty()) << kind->name;
  }
}

TEST(EveryShape, ThatIsAFlatBoxIsDrawnAsTwoFaces) {
  const auto sheet = R3::MakeShape("box", {0, 1, 0, 2, 1, 3});
  for (const Facet& facet : Facets(sheet->Tessellate(8))) EXPECT_EQ(std::abs(facet.front.y), 1);
  EXPECT_EQ(sheet->Tessellate(8).triangles.size(), 2u * 2 * 2 * 2);
}

/// Texture coordinates where a ray straight at `p` from outside meets the shape.
R2::Point At(const R3::Shape& shape, const R3::Point& p, const R3::Vector& from) {
  const R3::Ray ray{p + from, -from};
  const auto hit = shape.Intersect(ray, 0);
  EXPECT_TRUE(hit);
  return hit ? shape.At(ray, *hit, 0).uv : R2::Point{-1, -1};
}

void ExpectUv(const R2::Point& uv, double u, double v) {
  EXPECT_NEAR(uv.x, u, 1e-12);
  EXPECT_NEAR(uv.y, v, 1e-12);
}

TEST(TextureCoordinates, OfASphereHaveTheirPolesOnZ) {
  const auto sphere = R3::MakeShape("sphere", {0, 0, 0, 1});
  ExpectUv(At(*sphere, {0, 1, 0}, {0, 1, 0}), 0, 0.5);
  ExpectUv(At(*sphere, {1, 0, 0}, {1, 0, 0}), 0.25, 0.5);
  ExpectUv(At(*sphere, {0, -1, 0}, {0, -1, 0}), 0.5, 0.5);
  ExpectUv(At(*sphere, {-1, 0, 0}, {-1, 0, 0}), 0.75, 0.5);
  EXPECT_NEAR(At(*sphere, {0, 0, 1}, {0, 0, 1}).y, 1, 1e-7);
  EXPECT_NEAR(At(*sphere, {0, 0, -1}, {0, 0, -1}).y, 0, 1e-7);
}

TEST(TextureCoordinates, OfConesAndCylindersRunUpSidesAndAcrossEnds) {
  const auto cylinder = R3::MakeShape("cylinder", {0, 0, 0, 1, 2}), cone = R3::MakeShape("cone", {0, 0, 0, 1, 2});
  ExpectUv(At(*cylinder, {0, 0, -1}, {0, 0, -1}), 0, 0.5);
  ExpectUv(At(*cylinder, {1, 0.5, 0}, {1, 0, 0}), 0.25, 0.75);
  ExpectUv(At(*cylinder, {0, -0.5, 1}, {0, 0, 1}), 0.5, 0.25);
  ExpectUv(At(*cylinder, {-1, 0, 0}, {-1, 0, 0}), 0.75, 0.5);
  ExpectUv(At(*cylinder, {0.5, 1, 0.25}, {0, 1, 0}), 0.75, 0.375);
  ExpectUv(At(*cylinder, {0.5, -1, 0.25}, {0, -1, 0}), 0.75, 0.375);
  ExpectUv(At(*cone, {0.5, 0, 0}, {1, 0, 0}), 0.25, 0.5);
  ExpectUv(At(*cone, {0.5, -1, 0.25}, {0, -1, 0}), 0.75, 0.375);
}

TEST(TextureCoordinates, OfABoxFollowTheFaceTable) {
  const auto box = R3::MakeShape("box", {0, 0, 0, 1, 1, 1});
  const double x = 0.25, y = 0.5, z = 0.875;
  ExpectUv(At(*box, {0, y, z}, {-1, 0, 0}), 1 - y, z);
  ExpectUv(At(*box, {1, y, z}, {1, 0, 0}), y, z);
  ExpectUv(At(*box, {x, 0, z}, {0, -1, 0}), x, z);
  ExpectUv(At(*box, {x, 1, z}, {0, 1, 0}), 1 - x, z);
  ExpectUv(At(*box, {x, y, 0}, {0, 0, -1}), x, 1 - y);
  ExpectUv(At(*box, {x, y, 1}, {0, 0, 1}), x, y);
}

TEST(TextureCoordinates, OfATriangleAreItsBarycentricCoordinates) {
  const auto tri = R3::MakeShape("tri", {0, 0, 0, 4, 0, 0, 0, 2, 0});
  ExpectUv(At(*tri, {1, 0.5, 0}, {0, 0, 1}), 0.25, 0.25);
  ExpectUv(At(*tri, {2, 0.5, 0}, {0, 0, -1}), 0.5, 0.25);
}

}  // namespace
