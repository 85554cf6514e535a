#include <cmath>
#include <vector>

#include "R3/GridMesh.h"
#include "R3/Numeric.h"
#include "R3/shapes/BezierPatch.h"

namespace R3 {
namespace {

using namespace patch;

/// A bicubic patch; its front is the side from which u runs to the right and v upward.
class Bezier : public Shape {
 public:
  /// Makes a patch from control points, given as vectors from the origin.
  Bezier(const Net<Vector>& net, Recipe made_from) : net_(net), made_from_(std::move(made_from)) {
    for (const auto& row : net_)
      for (const Vector& p : row) box_.Extend(Point{} + p);
    const double size = MaxComponent(box_.Size());
    if (size > 0) to_unit_ = -std::ilogb(size);
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t i = 0; i < 4; ++i) unit_net_[j][i] = ScaledByPower(net_[j][i] - net_[0][0], to_unit_);
    is_degenerate_ = LiesInLine();
  }

  Box Bounds(int) const override { return box_; }

  std::optional<Hit> Intersect(const Ray& ray, int) const override {
    if (is_degenerate_ || !IsFinite(ray.direction) || !IsFinite(FromOrigin(ray.origin))) return {};
    if (ray.direction == Vector{}) return {};
    std::optional<Hit> nearest;
    for (const Hit& hit : Hits(ray))
      if (hit.t > ray.t_min && hit.t < ray.t_max && !(nearest && nearest->t <= hit.t)) nearest = hit;
    return nearest;
  }

  Intersection At(const Ray&, const Hit& hit, int) const override {
    const auto along_u = Weights(hit.u), along_v = Weights(hit.v);
    Intersection at;
    at.position = Point{} + Blend(net_, along_u, along_v);
    // Weights 4 u, their product and that with a point 2 u, sums 15 u; relative to the magnitudes, which the weights do
    // not exceed.
    at.error = Gamma(21) * Vector{Reach(0), Reach(1), Reach(2)};
    at.normal = at.shading_normal = NormalAt(hit.u, hit.v);
    at.uv = {hit.u, hit.v};
    at.v_ends = {VEnd::rim, VEnd::rim};
    return at;
  }

  UvTangents UvTangentsAt(const Ray&, const Hit& hit, int) const override {
    const Vector of_u = Blend(unit_net_, WeightSlopes(hit.u), Weights(hit.v));
    const Vector of_v = Blend(unit_net_, Weights(hit.u), WeightSlopes(hit.v));
    return {ScaledByPower(of_u, -to_unit_), ScaledByPower(of_v, -to_unit_)};
  }

  MeshData Tessellate(int fineness) const override {
    MeshData data;
    if (is_degenerate_) return data;
    const int pieces = std::max(4, fineness / 2);
    AddGrid(data, pieces, pieces, [&](int column, int row) {
      const double u = static_cast<double>(column) / pieces, v = static_cast<double>(row) / pieces;
      return GridCorner{Point{} + Blend(net_, Weights(u), Weights(v)), NormalAt(u, v), {u, v}};
    });
    return data;
  }

  bool IsSolid() const override { return false; }
  bool IsDegenerate() const override { return is_degenerate_; }

  std::optional<Recipe> MadeFrom() const override { return made_from_; }

 private:
  double Reach(int axis) const { return std::max(std::abs(box_.low[axis]), std::abs(box_.high[axis])); }

  bool LiesInLine() const {
    for (const auto& row : unit_net_)
      for (const Vector& p : row)
        for (const auto& other : unit_net_)
          for (const Vector& q : other)
            if (!(Cross(p, q) == Vector{})) return false;
    return true;
  }

  /// Returns the normal; if corners coincide, that at a point slightly towards the middle.
  Normal NormalAt(double u, double v) const {
    double step = 0;
    do {
      const double near_u = u + step * (0.5 - u), near_v = v + step * (0.5 - v);
      const Vector normal = Cross(Blend(unit_net_, WeightSlopes(near_u), Weights(near_v)),
                                  Blend(unit_net_, Weights(near_u), WeightSlopes(near_v)));
      // Smaller results are rounding errors of zero, in units of the patch.
      if (MaxComponent(Abs(normal)) > 64 * unit_roundoff) return AsNormal(Unit(normal));
      step = step > 0 ? 16 * step : 0x1p-40;
    } while (step < 1);
    return {0, 0, 1};
  }

  std::vector<Hit> Hits(const Ray& ray) const {
    // Two directions perpendicular to the ray: exact if it runs along an axis, nearly unit.
    const Vector d = Unit(ray.direction);
    const int axis = MaxAxis(d);
    const Vector e{axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0, axis == 0 ? 1.0 : 0.0};
    const Vector across = Unit(Cross(d, e)), other = Cross(d, across);
    Net<Vector> from_origin;
    Net<Miss> misses;
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t i = 0; i < 4; ++i) {
        from_origin[j][i] = ScaledByPower(Point{} + net_[j][i] - ray.origin, to_unit_);
        misses[j][i] = {Dot(across, from_origin[j][i]), Dot(other, from_origin[j][i])};
      }
    const double length = std::scalbn(Length(ray.direction), to_unit_);
    const RootFinder finder(misses);
    std::vector<Hit> hits;
    for (const bool is_proven : {true, false})
      for (const Root& root : finder.Roots()) {
        if (root.is_proven != is_proven) continue;
        const auto place = PlaceAt(root, misses);
        if (!place) continue;
        const Hit hit{.t = Dot(Blend(from_origin, Weights(place->u), Weights(place->v)), d) / length,
                      .u = place->u,
                      .v = place->v};
        if (!IsAmong(hits, hit, is_proven ? 0 : length)) hits.push_back(hit);
      }
    return hits;
  }

  /// Returns true if a hit is a duplicate. A zero that is found from two cells differs by rounding; a touch is found
  /// from all the smallest cells around it, and so is a corner of coincident points, whatever u is there.
  ///   length   of the ray's direction in units of the patch, for a zero that is not proven to be distinct
  static bool IsAmong(const std::vector<Hit>& hits, const Hit& hit, double length) {
    // The square root of rounding, which is the size of RootFinder's smallest cells along u and v; and some such cells.
    constexpr double same = 0x1p-26, near = 0x1p-20;
    for (const Hit& known : hits) {
      if (std::abs(known.u - hit.u) < same && std::abs(known.v - hit.v) < same) return true;
      if (std::abs(known.t - hit.t) * length < near && length > 0) return true;
    }
    return false;
  }

  /// Refines a root by Newton's method to the last bits, from a start known to converge or close to the root;
  /// std::nullopt beyond the edges.
  static std::optional<Root> PlaceAt(const Root& root, const Net<Miss>& misses) {
    constexpr int most_steps = 12;
    Root place = root;
    for (int step = 0; step < most_steps; ++step) {
      const auto wu = Weights(place.u), wv = Weights(place.v);
      const Miss at = Blend(misses, wu, wv), of_u = Blend(misses, WeightSlopes(place.u), wv),
                 of_v = Blend(misses, wu, WeightSlopes(place.v));
      const double determinant = DifferenceOfProducts(of_u.x, of_v.y, of_v.x, of_u.y);
      const double by_u = (at.x * of_v.y - at.y * of_v.x) / determinant;
      const double by_v = (at.y * of_u.x - at.x * of_u.y) / determinant;
      if (!std::isfinite(by_u) || !std::isfinite(by_v)) break;
      place.u -= by_u, place.v -= by_v;
      if (std::abs(by_u) + std::abs(by_v) < 2 * unit_roundoff) break;
    }
    const bool has_stayed = std::abs(place.u - root.u) <= root.du && std::abs(place.v - root.v) <= root.dv;
    if (!root.is_proven && !has_stayed) place = root;
    // The distance beyond an edge that exceeds rounding. Neighboring patches that share the edge overlap by this much.
    constexpr double rounding = 16 * unit_roundoff;
    const auto is_on_patch = [](double x) { return x >= -rounding && x <= 1 + rounding; };
    if (!is_on_patch(place.u) || !is_on_patch(place.v)) return {};
    place.u = std::clamp(place.u, 0.0, 1.0), place.v = std::clamp(place.v, 0.0, 1.0);
    return place;
  }

  Net<Vector> net_;
  Recipe made_from_;
  Net<Vector> unit_net_;  // relative to its first corner, times 2^to_unit_, which brings its size into [1, 2)
  int to_unit_ = 0;
  Box box_;
  bool is_degenerate_ = false;
};

}  // namespace

std::vector<Argument> PatchArguments() {
  return {{"x1"},  {"y1"},  {"z1"},  {"x2"},  {"y2"},  {"z2"},  {"x3"},  {"y3"},  {"z3"},  {"x4"},  {"y4"},  {"z4"},
          {"x5"},  {"y5"},  {"z5"},  {"x6"},  {"y6"},  {"z6"},  {"x7"},  {"y7"},  {"z7"},  {"x8"},  {"y8"},  {"z8"},
          {"x9"},  {"y9"},  {"z9"},  {"x10"}, {"y10"}, {"z10"}, {"x11"}, {"y11"}, {"z11"}, {"x12"}, {"y12"}, {"z12"},
          {"x13"}, {"y13"}, {"z13"}, {"x14"}, {"y14"}, {"z14"}, {"x15"}, {"y15"}, {"z15"}, {"x16"}, {"y16"}, {"z16"}};
}

Net<Vector> PatchNet(std::span<const double> a) {
  Net<Vector> net;
  for (std::size_t k = 0; k < 16; ++k) net[k / 4][k % 4] = {a[3 * k], a[3 * k + 1], a[3 * k + 2]};
  return net;
}

std::unique_ptr<const Shape> BezierPatch(const Net<Vector>& net, Recipe made_from) {
  return std::make_unique<Bezier>(net, std::move(made_from));
}

extern const ShapeKind bezier_kind{
    "bezier",
    "a bicubic patch by 16 control points, four rows of four: along a row u grows, from row to row v; its front is "
    "where u runs to the right and v upward",
    PatchArguments(),
    [](std::span<const double> a) { return BezierPatch(PatchNet(a), Recipe{"bezier", {a.begin(), a.end()}}); },
    {-1,  -0.2, -1,   -0.4, 0.5,  -1.1, 0.3, -0.3, -1,  1,   0.2, -1,   -1.1, 0.3, -0.4, -0.3,
     0.9, -0.3, 0.4,  0.6,  -0.3, 1.1,  0.1, -0.4, -1,  0.2, 0.3, -0.4, 0.8,  0.4, 0.3,  0.4,
     0.3, 1,    -0.3, 0.4,  -1,   -0.1, 1,   -0.3, 0.3, 1.1, 0.4, -0.2, 1,    1,   0.3,  1},
};

}  // namespace R3
