#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "R3/Mesh.h"
#include "source/accelerate/World.h"
#include "tests/ExactRing.h"
#include "tests/ExactSolid.h"
#include "tests/ExactTriangle.h"

/// A whole scene in 113 bits, without any structure: the judge of what rays hit.
namespace oracle {

/// Where on a ray a surface is crossed, as far as the rounding that the program is allowed leaves it open; within that
/// a surface that is only grazed may be crossed or not.
struct Crossing {
  Quad low, high;
  bool is_certain;
};

/// An affine map.
class Map {
 public:
  Map operator*(const R3::Matrix& next) const {
    Map product;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 4; ++j) {
        product.m_[i][j] = j == 3 ? m_[i][3] : Quad(0);
        for (std::size_t k = 0; k < 3; ++k) product.m_[i][j] += m_[i][k] * Quad(next.m[k][j]);
      }
    return product;
  }
  Vector OfPoint(const Vector& p) const { return OfVector(p) + Column(3); }
  Vector OfVector(const Vector& v) const { return v.x * Column(0) + v.y * Column(1) + v.z * Column(2); }
  /// What the sums of OfPoint and OfVector are made of at most: their rounding is in proportion to it.
  Quad SizeOfPoint(const Vector& p) const { return SizeOfVector(p) + Largest(Column(3)); }
  Quad SizeOfVector(const Vector& v) const {
    return Abs(v.x) * Largest(Column(0)) + Abs(v.y) * Largest(Column(1)) + Abs(v.z) * Largest(Column(2));
  }
  Map Inverse() const {
    const Vector a = Column(0), b = Column(1), c = Column(2);
    const Quad determinant = Dot(a, Cross(b, c));
    const std::array<Vector, 3> rows{Cross(b, c), Cross(c, a), Cross(a, b)};
    Map inverse;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector row = 1 / determinant * rows[i];
      inverse.m_[i] = {row.x, row.y, row.z, -Dot(row, Column(3))};
    }
    return inverse;
  }

  static Quad Largest(const Vector& v) { return std::max({Abs(v.x), Abs(v.y), Abs(v.z)}); }

 private:
  Vector Column(std::size_t j) const { return {m_[0][j], m_[1][j], m_[2][j]}; }

  std::array<std::array<Quad, 4>, 3> m_{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
};

/// A line as a shape sees it, and by how much its points may be off because they were rounded on the way.
struct SeenLine {
  Line line;
  Quad error_at_origin = 0, error_per_t = 0;

  /// The largest error within `reach` of the origin.
  Quad ErrorWithin(Quad reach) const { return error_at_origin + reach / Length(line.d) * error_per_t; }
  /// Whether it passes a ball by more than any rounding; in doubles, so that most of a mesh costs little.
  bool Misses(const Vector& center, double radius) const {
    const R3::Vector to{Double(center.x - line.o.x), Double(center.y - line.o.y), Double(center.z - line.o.z)};
    const R3::Vector d{Double(line.d.x), Double(line.d.y), Double(line.d.z)};
    const double margin = 1e-6 * (R3::Length(to) + radius);  // orders above any error here
    return R3::Length(R3::Cross(to, R3::Unit(d))) > radius + margin + Double(ErrorWithin(R3::Length(to) + radius));
  }
};

/// Crossings of shapes that were allowed an error of `bar` of what is within their reach.
class Crossings {
 public:
  /// The bar of Shape::Intersect.
  static constexpr double of_shape = 32 * R3::unit_roundoff;

  static std::vector<Crossing> OfSolid(const Solid& solid, const SeenLine& seen) {
    const Quad away = Length(seen.line.o - Of(solid.Center())), size = solid.Size();
    const Quad bar = of_shape * std::max(away, size) + seen.ErrorWithin(away + size);
    const Stretch larger = solid.Inside(seen.line, bar), smaller = solid.Inside(seen.line, -bar);
    if (larger.IsEmpty()) return {};
    if (smaller.IsEmpty()) return {{larger.enter, larger.leave, false}};
    return {{larger.enter, smaller.enter, true}, {smaller.leave, larger.leave, true}};
  }

  static std::vector<Crossing> OfPlane(const Vector& point, const Vector& normal, const SeenLine& seen) {
    const Quad towards = Dot(normal, seen.line.d), length = Length(seen.line.d);
    const Quad cosine = Abs(towards) / (Length(normal) * length);
    // Along the plane it may be met anywhere: where the line's own direction is not known better.
    if (cosine <= 2 * (of_shape + seen.error_per_t / length)) return {{-R3::infinity, R3::infinity, false}};
    const Quad t = Dot(normal, point - seen.line.o) / towards, reach = Length(point - seen.line.o) + Abs(t) * length;
    const Quad around = (of_shape * reach + seen.ErrorWithin(reach)) / (cosine * length);
    return {{t - around, t + around, true}};
  }

  static std::vector<Crossing> OfDisc(const Vector& center, const Vector& normal, Quad radius, const SeenLine& seen) {
    if (seen.Misses(center, Double(radius))) return {};
    std::vector<Crossing> crossings = OfPlane(center, normal, seen);
    Crossing& crossing = crossings.front();
    if (!crossing.is_certain) return crossings;
    const Vector place = seen.line.At((crossing.low + crossing.high) / 2);
    const Quad reach = Length(center - seen.line.o) + radius;
    const Quad bar = of_shape * reach + seen.ErrorWithin(reach) +
                     (crossing.high - crossing.low) / 2 * Length(seen.line.d);  // along the plane it may be off by that
    const Quad inside = radius - Length(place - center);
    if (inside < -bar) return {};
    crossing.is_certain = inside > bar;
    return crossings;
  }

  static std::vector<Crossing> OfRing(const Ring& ring, const SeenLine& seen) {
    const Quad away = Length(seen.line.o), size = ring.Size();
    const Quad bar = of_shape * (away + size) + seen.ErrorWithin(away + size);
    const std::vector<Quad> breaks = ring.Breaks(seen.line, bar);
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const Quad from = ring.Outside(seen.line.At(breaks[i])), to = ring.Outside(seen.line.At(breaks[i + 1]));
      if ((from > bar && to > bar) || (from < -bar && to < -bar)) continue;
      const auto place = [&](Quad level) { return Where(ring, seen.line, breaks[i], breaks[i + 1], level); };
      const Quad out = place(bar), in = place(-bar);
      crossings.push_back(
          {std::min(out, in), std::max(out, in), std::max(from, to) > bar && std::min(from, to) < -bar});
    }
    return crossings;
  }

  ///   corner_error   by which corners themselves may be off
  static std::vector<Crossing> OfTriangle(const std::array<Vector, 3>& corners, Quad corner_error,
                                          const SeenLine& seen) {
    const Quad size =
        std::max({Length(corners[1] - corners[0]), Length(corners[2] - corners[1]), Length(corners[0] - corners[2])});
    if (seen.Misses(corners[0], Double(size))) return {};
    const TriangleCrossing truth(corners, seen.line);
    if (!(truth.cosine > 0)) return {{-R3::infinity, R3::infinity, false}};
    const Quad area = Length(Cross(corners[1] - corners[0], corners[2] - corners[0])),
               reach = Length(corners[0] - seen.line.o) + size;
    // A corner that is off turns what is narrow by as many times more as it is longer than high.
    const Quad bar = of_shape * reach + seen.ErrorWithin(reach) + corner_error * size * size / area;
    if (truth.inside < -bar) return {};
    const Quad around = bar / (truth.cosine * Length(seen.line.d));
    return {{truth.t - around, truth.t + around, truth.inside > bar}};
  }

 private:
  /// Where Outside passes the level between two breaks, or the end that is nearer to it.
  static Quad Where(const Ring& ring, const Line& line, Quad low, Quad high, Quad level) {
    const bool rises = ring.Outside(line.At(low)) < ring.Outside(line.At(high));
    for (int i = 0; i < 113; ++i) {
      const Quad middle = low + (high - low) / 2;
      ((ring.Outside(line.At(middle)) < level) == rises ? low : high) = middle;
    }
    return low;
  }
};

/// Every shape of a world where the scene puts it.
class Scene {
 public:
  /// Looks into the world, which must outlive it and have left nothing out.
  explicit Scene(const ray::World& world) {
    std::map<const ray::Node*, Placed> placed;
    Place(world.scene().root, {}, placed);
    for (const ray::Instance& instance : world.Instances()) {
      Placed& its = placed.at(instance.node);  // a node has one place
      its.mesh = dynamic_cast<const R3::Mesh*>(its.shape);
      its.is_baked = its.mesh && instance.mesh != its.mesh;
      placed_.push_back(its);
    }
  }

  /// What is wrong with the answer to a ray; empty for nothing.
  std::string WhatIsWrong(const R3::Ray& ray, const std::optional<ray::WorldHit>& hit) const {
    if (!IsFinite(ray.origin - R3::Point{}) || !IsFinite(ray.direction)) return hit ? "a hit of no ray" : "";
    if (hit && !(hit->t > ray.t_min && hit->t < ray.t_max)) return "a hit outside the ray's interval";
    const Quad begin = ray.t_min, end = hit ? hit->t : ray.t_max;
    bool is_on_its_shape = !hit;
    for (std::size_t i = 0; i < placed_.size(); ++i)
      for (const Crossing& crossing : CrossingsOf(placed_[i], ray)) {
        is_on_its_shape |= hit && hit->instance == i && end >= crossing.low && end <= crossing.high;
        if (crossing.is_certain && crossing.low > begin && crossing.high < end)
          return "passed over shape " + std::to_string(i) + " at t " + std::to_string(Double(crossing.low));
      }
    return is_on_its_shape ? "" : "no crossing of shape " + std::to_string(hit->instance) + " is there";
  }

 private:
  /// Entries within an ulp, three products, three sums, and motion: of each sum of a map.
  static constexpr double of_map = 16 * R3::unit_roundoff;

  struct Placed {
    const R3::Shape* shape = nullptr;
    const R3::Mesh* mesh = nullptr;  // the same, if it is one
    bool is_baked = false;           // its corners were moved into the world
    Map world_from_local, local_from_world;
    Vector motion;
  };

  static void Place(const ray::Node& node, Placed above, std::map<const ray::Node*, Placed>& placed) {
    above.motion = above.motion + above.world_from_local.OfVector(Of(node.motion));
    above.world_from_local = above.world_from_local * node.transform;
    if (node.shape) {
      above.shape = node.shape.get();
      above.local_from_world = above.world_from_local.Inverse();
      placed[&node] = above;
    }
    for (const ray::Node& child : node.children) Place(child, above, placed);
  }

  static SeenLine See(const Placed& placed, const R3::Ray& ray) {
    if (placed.is_baked) return {.line = Of(ray)};
    const Vector moved = Quad(ray.time) * placed.motion, origin = Of(ray.origin), d = Of(ray.direction);
    const Map& local = placed.local_from_world;
    return {{local.OfPoint(origin - moved), local.OfVector(d)},
            of_map * (local.SizeOfPoint(origin) + local.SizeOfVector(moved)),
            of_map * local.SizeOfVector(d)};
  }

  static std::vector<Crossing> CrossingsOf(const Placed& placed, const R3::Ray& ray) {
    if (placed.shape->IsDegenerate()) return {};
    const SeenLine seen = See(placed, ray);
    if (placed.mesh) return OfMesh(placed, seen);
    const R3::Recipe made = placed.shape->MadeFrom().value();
    const std::vector<double>& a = made.arguments;
    const std::string kind = made.kind;
    if (kind == "plane") return Crossings::OfPlane({a[0], a[1], a[2]}, {a[3], a[4], a[5]}, seen);
    if (kind == "disc") return Crossings::OfDisc({a[0], a[1], a[2]}, {a[3], a[4], a[5]}, a[6], seen);
    if (kind == "torus") {
      SeenLine centered = seen;
      centered.line.o = centered.line.o - Vector{a[0], a[1], a[2]};
      // Subtracting the center loses a share of the center's own size.
      centered.error_at_origin += Crossings::of_shape * Length(Vector{a[0], a[1], a[2]});
      return Crossings::OfRing({a[3], a[4]}, centered);
    }
    Solid solid{kind, a};
    for (std::size_t i = 0; kind == "box" && i < 3; ++i)
      if (a[i] > a[i + 3]) std::swap(solid.arguments[i], solid.arguments[i + 3]);
    return Crossings::OfSolid(solid, seen);
  }

  static std::vector<Crossing> OfMesh(const Placed& placed, const SeenLine& seen) {
    std::vector<Crossing> crossings;
    for (int element = 0; element < placed.mesh->Elements(); ++element) {
      std::array<Vector, 3> corners;
      Quad error = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = Of(placed.mesh->Corners(element)[i]);
        if (!placed.is_baked) continue;
        error = std::max(error, of_map * placed.world_from_local.SizeOfPoint(corners[i]));
        corners[i] = placed.world_from_local.OfPoint(corners[i]);
      }
      for (const Crossing& crossing : Crossings::OfTriangle(corners, error, seen)) crossings.push_back(crossing);
    }
    return crossings;
  }

  std::vector<Placed> placed_;  // as the instances of the world
};

}  // namespace oracle
