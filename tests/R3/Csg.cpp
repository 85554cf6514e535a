// Solids made of solids: the hits of a ray agree with sets of points, however the solids are placed.
#include "R3/Csg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "R3/Implicit.h"
#include "R3/Placement.h"
#include "R3/ShapeKind.h"
#include "source/parse/CsgOf.h"
#include "tests/Accelerators.h"
#include "tests/Draw.h"
#include "tests/ExactScene.h"

namespace {

using ray::CsgOf;
using ray::Node;
using R3::RotationAbout;
using R3::Translation;
using enum R3::CsgOperation;

Node Solid(const std::string& kind, const std::vector<double>& arguments) {
  return accelerators::Leaf(R3::MakeShape(kind, arguments));
}

/// Returns the children in a group, or combined.
template <class... Children>
Node With(Node parent, Children&&... children) {
  (parent.children.push_back(std::forward<Children>(children)), ...);
  return parent;
}

template <class... Children>
Node Combined(R3::CsgOperation operation, Children&&... children) {
  Node node;
  node.operation = operation;
  return With(std::move(node), std::forward<Children>(children)...);
}

template <class... Children>
Node Placed(const R3::Matrix& transform, Children&&... children) {
  Node node;
  node.transform = transform;
  return With(std::move(node), std::forward<Children>(children)...);
}

std::vector<double> AllHits(const R3::Shape& shape, R3::Ray ray) {
  std::vector<double> all;
  while (const auto hit = shape.Intersect(ray, 0)) all.push_back(hit->t), ray.t_min = hit->t;
  return all;
}

R3::Ray RayAt(Draw& draw, const R3::Box& box) {
  const R3::Vector size = box.Size();
  const R3::Point target =
      box.low + R3::Vector{size.x * draw.Between(0, 1), size.y * draw.Between(0, 1), size.z * draw.Between(0, 1)};
  const R3::Vector direction = draw.Direction();
  return {target - 3 * box.Radius() * direction, direction};
}

TEST(Csg, ABoxMinusACylinderHasARoundHole) {
  // The hole's faces coincide exactly with those of the box.
  const auto plate = CsgOf(Combined(subtract, Solid("box", {-2, -1, -2, 2, 1, 2}), Solid("cylinder", {0, 0, 0, 1, 2})));
  EXPECT_TRUE(AllHits(*plate, {{0.3, 5, 0.4}, {0, -1, 0}}).empty());
  EXPECT_EQ(AllHits(*plate, {{1.3, 5, 0.4}, {0, -1, 0}}), (std::vector<double>{4, 6}));
  const std::vector<double> across = AllHits(*plate, {{-5, 0, 0}, {1, 0, 0}});
  ASSERT_EQ(across.size(), 4u);
  EXPECT_EQ(across[0], 3);
  EXPECT_EQ(across[3], 7);
  EXPECT_NEAR(across[1], 4, 1e-15);
  EXPECT_NEAR(across[2], 6, 1e-15);
  // The wall of the hole faces the axis.
  const R3::Ray ray{{0, 0, 0}, {1, 0, 0}};
  const auto wall = plate->Intersect(ray, 0);
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->t, 1, 1e-15);
  EXPECT_NEAR(plate->At(ray, *wall, 0).normal.x, -1, 1e-15);
}

TEST(Csg, TheIntersectionOfTwoBallsIsALens) {
  // Balls of radius 5 about (0, 0, -4) and (0, 0, 4): the lens is 2 thick and its rim has a radius of 3.
  const auto lens = CsgOf(Combined(intersect, Solid("sphere", {0, 0, -4, 5}), Solid("sphere", {0, 0, 4, 5})));
  for (const double x : {0.0, 1.0, 2.0, 2.9, 2.999}) {
    const std::vector<double> hits = AllHits(*lens, {{x, 0, 10}, {0, 0, -1}});
    const double half = std::sqrt(25 - x * x) - 4;
    ASSERT_EQ(hits.size(), 2u) << x;
    EXPECT_NEAR(hits[0], 10 - half, 1e-13);
    EXPECT_NEAR(hits[1], 10 + half, 1e-13);
  }
  EXPECT_TRUE(AllHits(*lens, {{3.001, 0, 10}, {0, 0, -1}}).empty());
  const R3::Box box = lens->Bounds(0);
  EXPECT_EQ(box.low.z, -1);
  EXPECT_EQ(box.high.z, 1);
}

TEST(Csg, BoundsAreThoseOfTheRemainder) {
  const auto boxed = [](R3::CsgOperation operation) {
    return CsgOf(Combined(operation, Solid("box", {0, 0, 0, 2, 2, 2}), Solid("box", {1, 1, 1, 5, 3, 4})))->Bounds(0);
  };
  EXPECT_EQ(boxed(unite), (R3::Box{{0, 0, 0}, {5, 3, 4}}));
  EXPECT_EQ(boxed(intersect), (R3::Box{{1, 1, 1}, {2, 2, 2}}));
  EXPECT_EQ(boxed(subtract), (R3::Box{{0, 0, 0}, {2, 2, 2}}));
}

/// Makes a bumpy mesh, its fronts outward.
std::shared_ptr<const R3::Mesh> BumpySolid() {
  R3::MeshData data = accelerators::BumpyBall(12, 9);
  for (auto& triangle : data.triangles) std::swap(triangle[1], triangle[2]);
  auto ball = std::make_shared<const R3::Mesh>(std::move(data));
  EXPECT_TRUE(ball->IsClosed());
  return ball;
}

/// Makes one shape of each kind, placed with and without a transform.
std::vector<Node> SomeSolids(const R3::Matrix& transform) {
  std::vector<Node> solids;
  for (const auto* kind : BoundedShapeKinds()) {
    const std::shared_ptr<const R3::Shape> shape = kind->make(kind->example);
    if (!shape->IsSolid()) continue;
    solids.push_back(Placed(transform, accelerators::Leaf(shape)));
  }
  solids.push_back(Placed(transform, accelerators::Leaf(BumpySolid())));
  return solids;
}

Node Again(const Node& solid) { return Placed(solid.transform, accelerators::Leaf(solid.children.at(0).shape)); }

TEST(Csg, ASolidWithItselfIsItselfAndLessItselfNothing) {
  Draw draw(31);
  for (const R3::Matrix& transform : {R3::Matrix{}, draw.Affine(0), draw.Affine(2)})
    for (const Node& solid : SomeSolids(transform)) {
      const auto alone = CsgOf(Combined(unite, Again(solid)));
      const auto both = CsgOf(Combined(unite, Again(solid), Again(solid)));
      const auto common = CsgOf(Combined(intersect, Again(solid), Again(solid)));
      const auto nothing = CsgOf(Combined(subtract, Again(solid), Again(solid)));
      for (int i = 0; i < Count(2000, 100'000); ++i) {
        const R3::Ray ray = RayAt(draw, alone->Bounds(0));
        const std::vector<double> hits = AllHits(*alone, ray);
        EXPECT_EQ(AllHits(*both, ray), hits) << oracle::Hex(ray);
        EXPECT_EQ(AllHits(*common, ray), hits) << oracle::Hex(ray);
        EXPECT_TRUE(AllHits(*nothing, ray).empty()) << oracle::Hex(ray);
      }
    }
}

TEST(Csg, ASolidAloneIsHitAsItIs) {
  // For meshes the lines exactly through edges and corners are also tested.
  Draw draw(37);
  for (const auto* kind : BoundedShapeKinds()) {
    const std::shared_ptr<const R3::Shape> shape = kind->make(kind->example);
    if (!shape->IsSolid()) continue;
    const auto csg = CsgOf(Combined(unite, accelerators::Leaf(shape)));
    int differ = 0;
    for (int i = 0; i < Count(5000, 100'000); ++i) {
      const R3::Ray ray = RayAt(draw, Bounds(*shape));
      differ += AllHits(*csg, ray) != AllHits(*shape, ray);
    }
    EXPECT_LE(differ, 1) << kind->name;  // chords shorter than rounding
  }
}

TEST(Csg, RaysEnterAMeshAsOftenAsTheyLeave) {
  const auto mesh = BumpySolid();
  const auto csg = CsgOf(Combined(unite, accelerators::Leaf(mesh)));
  Draw draw(41);
  for (int i = 0; i < Count(20'000, 1'000'000); ++i) {
    R3::Ray ray = RayAt(draw, csg->Bounds(0));
    const auto& corners = mesh->Data().positions;
    const auto corner = [&] {
      return corners[static_cast<std::size_t>(draw.Whole(0, static_cast<int>(corners.size()) - 1))];
    };
    if (i % 2 == 0) ray.direction = corner() - ray.origin;
    if (i % 4 == 1) ray = {{draw.Between(-2, 2), corner().y, -5}, {0, 0, 1}};
    const std::vector<double> hits = AllHits(*csg, ray);
    EXPECT_EQ(hits.size() % 2, 0u) << oracle::Hex(ray);
    // In the middle of a chord, another ray across it must find itself inside.
    if (hits.size() < 2 || hits[1] - hits[0] < 1e-6) continue;
    const R3::Ray across{ray.At((hits[0] + hits[1]) / 2), draw.Direction()};
    EXPECT_EQ(AllHits(*csg, across).size() % 2, 1u) << oracle::Hex(across);
  }
}

TEST(Csg, DeMorgansLawsHoldOfHits) {
  Draw draw(43);
  const auto all = [] { return Solid("box", {-5, -5, -5, 5, 5, 5}); };
  const auto a = [] { return Solid("sphere", {0.5, 0, 0, 1.5}); };
  const auto b = [] { return Solid("cylinder", {-0.5, 0, 0, 1, 3}); };
  const auto left = CsgOf(Combined(subtract, all(), Combined(unite, a(), b())));
  const auto right = CsgOf(Combined(intersect, Combined(subtract, all(), a()), Combined(subtract, all(), b())));
  const auto left_of_common = CsgOf(Combined(subtract, all(), Combined(intersect, a(), b())));
  const auto right_of_common = CsgOf(Combined(unite, Combined(subtract, all(), a()), Combined(subtract, all(), b())));
  for (int i = 0; i < Count(20'000, 1'000'000); ++i) {
    const R3::Ray ray = RayAt(draw, left->Bounds(0));
    EXPECT_EQ(AllHits(*left, ray), AllHits(*right, ray)) << oracle::Hex(ray);
    EXPECT_EQ(AllHits(*left_of_common, ray), AllHits(*right_of_common, ray)) << oracle::Hex(ray);
  }
}

TEST(Csg, RaysPassAHoleWhoseFacesAreRoundedDifferently) {
  // The box is rotated at once and the cylinder in two steps, so that faces that should coincide differ in their last
  // bits, which would leave a film in the hole.
  Draw draw(47);
  const R3::Vector axis{1, 2, 3};
  for (const double degrees : {30.0, 47.3}) {
    const auto about = [&](double angle) { return RotationAbout(axis, angle); };
    const R3::Matrix away = Translation({3, -7, 11});
    const auto plate = CsgOf(Combined(
        subtract, Placed(away, Placed(about(degrees), Solid("box", {-2, -1, -2, 2, 1, 2}))),
        Placed(
            Translation({3, -7, 10}),
            Placed(Translation({0, 0, 1}),
                   Placed(about(degrees / 3), Placed(about(2 * degrees / 3), Solid("cylinder", {0, 0, 0, 1, 2})))))));
    int stopped = 0;
    for (int i = 0; i < Asked("CSG_RAYS", 100'000, 1'000'000); ++i) {
      const auto in_hole = [&](double y) {
        const double r = 0.999 * std::sqrt(draw.Between(0, 1)), angle = draw.Between(0, 2 * std::numbers::pi);
        return away * (about(degrees) * R3::Point{r * std::cos(angle), y, r * std::sin(angle)});
      };
      const R3::Point top = in_hole(1), bottom = in_hole(-1);
      stopped += !AllHits(*plate, {top - (bottom - top), bottom - top}).empty();
    }
    EXPECT_EQ(stopped, 0);
  }
}

TEST(Csg, RaysPassAHoleMovedFarAwayAndBack) {
  // Both solids are rotated about a point 10^4 away and moved back, which costs digits that no number of the result
  // shows.
  Draw draw(48);
  const R3::Vector axis{1, 2, 3}, away{1e4, -3e4, 2e4};
  const auto turned = [&](const R3::Point& p) { return RotationAbout(axis, 40) * p; };
  const R3::Matrix back = Translation(FromOrigin(turned(R3::Point{} + away)) - away);
  const auto turned_there = [&](Node solid, const std::vector<double>& steps) {
    Node node = Placed(Translation(-away), std::move(solid));
    for (const double degrees : steps) node = Placed(RotationAbout(axis, degrees), std::move(node));
    return Placed(back, Placed(Translation(away), std::move(node)));
  };
  const auto plate = CsgOf(Combined(subtract, turned_there(Solid("box", {-2, -1, -2, 2, 1, 2}), {40}),
                                    turned_there(Solid("cylinder", {0, 0, 0, 1, 2}), {13, 7, 20})));
  int stopped = 0;
  for (int i = 0; i < Count(100'000, 1'000'000); ++i) {
    const auto in_hole = [&](double y) {
      const double r = 0.999 * std::sqrt(draw.Between(0, 1)), angle = draw.Between(0, 2 * std::numbers::pi);
      return turned({r * std::cos(angle), y, r * std::sin(angle)});
    };
    const R3::Point top = in_hole(1), bottom = in_hole(-1);
    stopped += !AllHits(*plate, {top - (bottom - top), bottom - top}).empty();
  }
  EXPECT_EQ(stopped, 0);
  EXPECT_FALSE(AllHits(*plate, {turned({1.5, 5, 0}), turned({0, -1, 0}) - R3::Point{}}).empty());
}

TEST(Csg, BallsThatTouchAreHitAsIfApart) {
  const auto two = CsgOf(Combined(unite, Solid("sphere", {-1, 0, 0, 1}), Solid("sphere", {1, 0, 0, 1})));
  // Through the point of contact there is no surface in between.
  EXPECT_EQ(AllHits(*two, {{-5, 0, 0}, {1, 0, 0}}), (std::vector<double>{3, 7}));
  // In the plane of contact there is at most a point.
  for (const R3::Vector d : {R3::Vector{0, 1, 0}, R3::Vector{0, 3, 4}})
    EXPECT_TRUE(AllHits(*two, {R3::Point{} - 4 * d, d}).empty());
  const auto common = CsgOf(Combined(intersect, Solid("sphere", {-1, 0, 0, 1}), Solid("sphere", {1, 0, 0, 1})));
  const auto left = CsgOf(Combined(subtract, Solid("sphere", {-1, 0, 0, 1}), Solid("sphere", {1, 0, 0, 1})));
  Draw draw(53);
  for (int i = 0; i < 10'000; ++i) {
    const R3::Vector d = draw.Direction();
    const R3::Ray ray{R3::Point{} - 5 * d, d};
    EXPECT_TRUE(AllHits(*common, ray).empty()) << oracle::Hex(ray);
    EXPECT_EQ(AllHits(*left, ray).size(), 2u) << oracle::Hex(ray);
    EXPECT_EQ(AllHits(*two, ray).size(), 2u) << oracle::Hex(ray);
  }
  // A ball that touches the floor of a hole, and a ray along that floor.
  const auto bowl = CsgOf(Combined(subtract, Solid("box", {-3, -3, -3, 3, 3, 3}), Solid("sphere", {0, -2, 0, 1})));
  EXPECT_EQ(AllHits(*bowl, {{0, 9, 0}, {0, -1, 0}}).size(), 2u);
}

TEST(Csg, TwoHundredNestedOperationsAreOneSolid) {
  // A row of balls, each cut off by the next: 1 - (2 - (3 - ...)).
  Node nested = Solid("sphere", {200, 0, 0, 0.75});
  for (int i = 199; i > 0; --i) nested = Combined(subtract, Solid("sphere", {i * 1.0, 0, 0, 0.75}), std::move(nested));
  const auto row = CsgOf(nested);
  // From the left, the ray enters ball 1 at 0.25 and leaves it at 1.25, where ball 2, not yet cut by ball 3, begins.
  const std::vector<double> hits = AllHits(*row, {{0, 0, 0}, {1, 0, 0}});
  ASSERT_EQ(hits.size(), 2u);
  EXPECT_NEAR(hits[0], 0.25, 1e-14);
  EXPECT_NEAR(hits[1], 1.25, 1e-14);
}

// Compares random trees with an oracle that knows each solid's stretch of the line in 113 bits, and evaluates the
// expression in the middle between any two ends.

struct Judged {
  Node node;
  R3::CsgOperation operation = unite;
  std::optional<oracle::Stretch> stretch{};  // of a solid
  std::vector<Judged> children{};

  bool Contains(Quad t) const {
    if (stretch) return stretch->enter < t && t < stretch->leave;
    const auto holds = [&](const Judged& child) { return child.Contains(t); };
    if (operation == unite) return std::ranges::any_of(children, holds);
    if (operation == intersect) return std::ranges::all_of(children, holds);
    return holds(children[0]) && std::none_of(children.begin() + 1, children.end(), holds);
  }
  void AddEnds(std::vector<Quad>& ends) const {
    if (stretch && !stretch->IsEmpty()) ends.push_back(stretch->enter), ends.push_back(stretch->leave);
    for (const Judged& child : children) child.AddEnds(ends);
  }
};

/// A tree without stretches, and with them for a line.
struct Tree {
  R3::CsgOperation operation = unite;
  std::optional<oracle::Solid> solid{};
  R3::Matrix frame{};
  std::vector<Tree> children{};

  Node ToNode() const {
    if (solid) return Placed(frame, Solid(solid->kind, solid->arguments));
    Node node = Combined(operation);
    for (const Tree& child : children) node.children.push_back(child.ToNode());
    return node;
  }
  Judged Along(const R3::Ray& ray) const {
    Judged judged{.node = {}, .operation = operation};
    if (solid) {
      const oracle::Map back = (oracle::Map() * frame).Inverse();
      const oracle::Line line{back.OfPoint(oracle::Of(ray.origin)), back.OfVector(oracle::Of(ray.direction))};
      judged.stretch = solid->Inside(line, 0);
    }
    for (const Tree& child : children) judged.children.push_back(child.Along(ray));
    return judged;
  }
};

/// Half of the solids are on a coarse grid, where faces often coincide exactly; the rest anywhere, rotated and sheared.
Tree RandomTree(Draw& draw, int levels, double scale) {
  if (levels == 0 || draw.Whole(0, 3) == 0) {
    const bool is_on_grid = draw.Whole(0, 1) == 1;
    const auto at = [&] { return scale * (is_on_grid ? draw.Whole(-2, 1) : draw.Between(-2, 2)); };
    const auto size = [&] { return scale * (is_on_grid ? draw.Whole(1, 2) : draw.Between(0.3, 2)); };
    Tree leaf;
    const R3::Point p{at(), at(), at()};
    switch (draw.Whole(0, 2)) {
      case 0:
        leaf.solid = {"box", {p.x, p.y, p.z, p.x + size(), p.y + size(), p.z + size()}};
        break;
      case 1:
        leaf.solid = {"sphere", {p.x, p.y, p.z, size()}};
        break;
      default:
        leaf.solid = {"cylinder", {p.x, p.y, p.z, size(), size()}};
    }
    if (!is_on_grid) {
      leaf.frame = draw.Affine(0);
      for (auto& row : leaf.frame.m) row[3] *= scale;
    }
    return leaf;
  }
  Tree tree{.operation = static_cast<R3::CsgOperation>(draw.Whole(0, 2))};
  for (int i = draw.Whole(2, 4); i > 0; --i) tree.children.push_back(RandomTree(draw, levels - 1, scale));
  return tree;
}

/// Returns the points where the line enters and leaves the solid according to the oracle; std::nullopt if ends are near
/// each other, but farther apart than rounding.
std::optional<std::vector<double>> Expected(const Judged& judged, double scale) {
  const Quad same = 1e-14 * scale, apart = 1e-7 * scale;  // sums of two numbers of the grid are rounded
  std::vector<Quad> ends;
  judged.AddEnds(ends);
  std::ranges::sort(ends);
  std::vector<double> expected;
  bool is_inside = false;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Quad gap = i + 1 < ends.size() ? ends[i + 1] - ends[i] : Quad(1);
    if (gap < same) continue;
    if (gap < apart) return {};
    const bool goes_on_inside = i + 1 < ends.size() && judged.Contains((ends[i] + ends[i + 1]) / 2);
    if (goes_on_inside != is_inside) expected.push_back(oracle::Double(ends[i]));
    is_inside = goes_on_inside;
  }
  return expected;
}

/// Counts the rays that could be judged.
struct Verdicts {
  int judged = 0, undecided = 0;
};

/// Compares the hits of rays with those of the oracle.
void Judge(const Tree& tree, Draw& draw, int rays, double scale, Verdicts& verdicts) {
  const auto csg = CsgOf(tree.ToNode());
  if (csg->IsDegenerate()) return;
  for (int i = 0; i < rays; ++i) {
    const R3::Ray ray = RayAt(draw, csg->Bounds(0));
    const auto expected = Expected(tree.Along(ray), scale);
    if (!expected) {
      ++verdicts.undecided;
      continue;
    }
    ++verdicts.judged;
    const std::vector<double> hits = AllHits(*csg, {ray.origin, ray.direction, -R3::infinity});
    ASSERT_EQ(hits.size(), expected->size())
        << testing::PrintToString(hits) << testing::PrintToString(*expected) << scale << ' ' << oracle::Hex(ray);
    for (std::size_t k = 0; k < hits.size(); ++k) EXPECT_NEAR(hits[k], (*expected)[k], 1e-11 * scale);
    // A ray that starts on the way finds the remaining hits, bit-identical.
    if (hits.empty()) continue;
    const std::vector<double> rest = AllHits(*csg, {ray.origin, ray.direction, hits[0]});
    EXPECT_TRUE(std::equal(rest.begin(), rest.end(), hits.begin() + 1, hits.end()));
    // So does one that starts and ends anywhere, which need not test all solids.
    R3::Ray part = ray;
    part.t_min = draw.Between(hits.front() - scale, hits.back()), part.t_max = draw.Between(part.t_min, hits.back());
    const auto first = std::ranges::upper_bound(hits, part.t_min);
    const auto hit = csg->Intersect(part, 0);
    ASSERT_EQ(hit.has_value(), first != hits.end() && *first < part.t_max) << oracle::Hex(part);
    if (hit) {
      EXPECT_EQ(hit->t, *first) << oracle::Hex(part);
    }
  }
}

TEST(Csg, H6_RandomTreesAreHitWhereSetsOfPointsSay) {
  Verdicts verdicts;
  // CSG_TREES is the total number of trees, with CSG_RAYS_OF_TREE rays each.
  const int trees = Asked("CSG_TREES", 180, 9000) / 3, rays = Asked("CSG_RAYS_OF_TREE", 100, 1000);
  for (const double scale : {1.0, 1e-6, 1e6})
    for (int seed = 0; seed < trees; ++seed) {
      Draw draw(static_cast<std::uint64_t>(seed) + 5900);
      Tree tree{.operation = static_cast<R3::CsgOperation>(seed % 3)};
      for (int i = 0; i < 3; ++i) tree.children.push_back(RandomTree(draw, 3, scale));
      SCOPED_TRACE("seed " + std::to_string(seed + 5900));
      Judge(tree, draw, rays, scale, verdicts);
      if (HasFatalFailure()) return;
    }
  EXPECT_GT(verdicts.judged, 3 * trees * rays / 2);
  EXPECT_LT(verdicts.undecided, verdicts.judged / 100);
}

TEST(Csg, ManySolidsAreHitWhereSetsOfPointsSay) {
  // Next to and inside one another, so that boxes exclude most of them.
  Verdicts verdicts;
  const int trees = Count(20, 400), rays = Count(50, 500);
  for (int seed = 0; seed < trees; ++seed) {
    Draw draw(static_cast<std::uint64_t>(seed) + 7300);
    const auto operation = [&] { return static_cast<R3::CsgOperation>(draw.Whole(0, 2)); };
    const auto small = [&] {
      Tree leaf{.solid = oracle::Solid{"sphere", {draw.Between(-4, 4), draw.Between(-4, 4), draw.Between(-4, 4), 1}}};
      if (draw.Whole(0, 1) == 0) leaf.solid = oracle::Solid{"box", {-3, -3, -3, 3, draw.Between(-2, 3), 3}};
      if (draw.Whole(0, 1) == 0) leaf.frame = draw.Affine(0);
      return leaf;
    };
    Tree tree = small();
    for (int level = 0; level < 20; ++level) {
      Tree next{.operation = operation()}, many;
      for (int i = draw.Whole(1, 12); i > 0; --i) many.children.push_back(small());
      next.children = {std::move(tree), std::move(many)};
      if (draw.Whole(0, 3) == 0) std::swap(next.children[0], next.children[1]);
      tree = std::move(next);
    }
    SCOPED_TRACE("seed " + std::to_string(seed + 7300));
    Judge(tree, draw, rays, 1, verdicts);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(verdicts.judged, trees * rays / 2);
  EXPECT_LT(verdicts.undecided, verdicts.judged / 100);
}

TEST(Csg, HandlesHundredsOfCrossingsOfOneSolid) {
  // Plates one tenth apart, two hundred crossings along x, clipped by a ball.
  const auto plates =
      std::make_shared<R3::Implicit>(R3::Expression("sin(20 pi x) + 0.5"), R3::Box{{-5.01, -1, -1}, {5.01, 1, 1}});
  const R3::Ray ray{{-9, 0.1, 0.2}, {1, 0, 0}};
  const std::vector<double> all = AllHits(*plates, ray);
  ASSERT_GT(all.size(), 190u);
  const auto csg = CsgOf(Combined(intersect, accelerators::Leaf(plates), Solid("box", {-3, -2, -2, 3, 2, 2})));
  std::vector<double> within{6};
  for (const double t : all)
    if (t > 6 && t < 12) within.push_back(t);
  if (within.size() % 2 == 1) within.push_back(12);
  std::vector<double> found = AllHits(*csg, ray);
  EXPECT_GT(found.size(), 110u);
  for (const double t : found)
    EXPECT_TRUE(std::ranges::any_of(within, [&](double x) { return std::abs(x - t) < 1e-12; })) << t;
}

TEST(Csg, NormalsFaceOutOfTheRemainder) {
  Draw draw(61);
  for (int seed = 0; seed < 30; ++seed) {
    const auto csg =
        CsgOf(RandomTree(draw, 3, 1).ToNode().children.empty() ? Combined(unite, Solid("box", {0, 0, 0, 1, 1, 1}))
                                                               : Combined(unite, RandomTree(draw, 3, 1).ToNode()));
    if (csg->IsDegenerate()) continue;
    for (int i = 0; i < 300; ++i) {
      R3::Ray ray = RayAt(draw, csg->Bounds(0));
      bool enters = true;
      while (const auto hit = csg->Intersect(ray, 0)) {
        const R3::Intersection at = csg->At(ray, *hit, 0);
        const double cosine = Dot(at.normal, ray.direction);
        EXPECT_TRUE(std::abs(cosine) < 1e-7 || (cosine < 0) == enters) << oracle::Hex(ray);
        ray.t_min = hit->t, enters = !enters;
      }
      EXPECT_TRUE(enters) << oracle::Hex(ray);
    }
  }
}

TEST(Csg, EveryAcceleratorFindsTheSame) {
  const auto ways = accelerators::EveryWay();
  for (int seed = 0; seed < Count(6, 300); ++seed) {
    Draw draw(static_cast<std::uint64_t>(seed) + 6700);
    ray::Scene scene;
    for (int i = 0; i < 5; ++i) {
      Node group = Placed(draw.Affine(1), Combined(static_cast<R3::CsgOperation>(i % 3)));
      Node& csg = group.children[0];
      for (int k = 0; k < 3; ++k) csg.children.push_back(RandomTree(draw, 2, 1).ToNode());
      csg.shape = CsgOf(csg);
      SetBounds(csg), SetBounds(group);
      scene.root.children.push_back(std::move(group));
    }
    SetBounds(scene.root);
    const ray::World world(scene);
    SCOPED_TRACE("seed " + std::to_string(seed + 6700));
    accelerators::Compare(world, accelerators::RaysAt(world, draw, 60), ways);
  }
}

TEST(Csg, InvalidRaysMissIt) {
  const auto csg = CsgOf(Combined(unite, Solid("sphere", {0, 0, 0, 1}), Solid("box", {0, 0, 0, 2, 2, 2})));
  const double nan = std::nan("");
  for (const R3::Vector d : {R3::Vector{0, 0, 0}, R3::Vector{nan, 0, 1}, R3::Vector{0, nan, 1}, R3::Vector{0, 0, nan},
                             R3::Vector{R3::infinity, 0, 0}})
    EXPECT_FALSE(csg->Intersect({{0, 0, -5}, d}, 0));
  EXPECT_FALSE(csg->Intersect({{nan, 0, -5}, {0, 0, 1}}, 0));
  EXPECT_FALSE(csg->Intersect({{0, R3::infinity, -5}, {0, 0, 1}}, 0));
}

}  // namespace
