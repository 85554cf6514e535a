// Patches of B-spline surfaces, compared with the recursion that defines their basis.

#include <gtest/gtest.h>

#include <array>

#include "R3/ShapeKind.h"
#include "tests/Draw.h"

namespace {

/// Makes rows of control points, `columns` in each.
struct Points {
  int columns;
  std::vector<R3::Point> at;

  std::unique_ptr<const R3::Shape> Patch(int column, int row) const {
    std::vector<double> numbers;
    for (int j = row; j < row + 4; ++j)
      for (int i = column; i < column + 4; ++i) {
        const R3::Point& p = at[static_cast<std::size_t>(j * columns + i)];
        numbers.insert(numbers.end(), {p.x, p.y, p.z});
      }
    return R3::MakeShape("bspline", numbers);
  }
};

Points RandomPoints(Draw& draw, int columns, int rows) {
  Points points{columns, {}};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      points.at.push_back({i + draw.Between(-0.3, 0.3), draw.Between(-1, 1), draw.Between(-0.3, 0.3) - j});
  return points;
}

/// Returns the basis function of this degree that begins at `knot`, with knots at the integers.
///   source   Cox (1972), de Boor (1972)
long double Basis(int degree, long double knot, long double x) {
  if (degree == 0) return x >= knot && x < knot + 1 ? 1 : 0;
  const long double n = degree;
  return (x - knot) / n * Basis(degree - 1, knot, x) + (knot + n + 1 - x) / n * Basis(degree - 1, knot + 1, x);
}

TEST(Bspline, LiesWhereDeBoorsRecursionSays) {
  Draw draw(93);
  for (int n = 0; n < 50; ++n) {
    const Points points = RandomPoints(draw, 4, 4);
    const auto patch = points.Patch(0, 0);
    for (int k = 0; k < 50; ++k) {
      const double u = draw.Between(0, 1), v = draw.Between(0, 1);
      std::array<long double, 3> sum{};
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
          const long double weight = Basis(3, i - 3, u) * Basis(3, j - 3, v);
          const R3::Point& p = points.at[static_cast<std::size_t>(4 * j + i)];
          for (int axis = 0; axis < 3; ++axis) sum[static_cast<std::size_t>(axis)] += weight * p[axis];
        }
      const R3::Intersection at = patch->At({}, {0, u, v, 0}, 0);
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(at.position[axis], static_cast<double>(sum[static_cast<std::size_t>(axis)]), at.error[axis]);
    }
  }
}

TEST(Bspline, NeighborsLeaveNoGapAndNoCrease) {
  Draw draw(94);
  const Points points = RandomPoints(draw, 5, 5);
  const auto left = points.Patch(0, 0), right = points.Patch(1, 0), below = points.Patch(0, 1);
  int through = 0;
  for (int i = 0; i < Count(5000, 1'000'000); ++i) {
    const bool is_right = i % 2 == 0;
    const double along = draw.Between(0.001, 0.999);
    const auto& other = is_right ? right : below;
    const R3::Hit here = is_right ? R3::Hit{0, 1, along, 0} : R3::Hit{0, along, 1, 0};
    const R3::Hit there = is_right ? R3::Hit{0, 0, along, 0} : R3::Hit{0, along, 0, 0};
    const R3::Intersection at = left->At({}, here, 0), across = other->At({}, there, 0);
    EXPECT_LE(Length(at.position - across.position), 1e-15);
    EXPECT_NEAR(Dot(at.normal, AsVector(across.normal)), 1, 1e-12);
    const R3::Vector direction = R3::Unit({draw.Between(-0.5, 0.5), -1, draw.Between(-0.5, 0.5)});
    const R3::Ray ray{at.position - draw.Scale(0, 2) * direction, direction};
    through += !left->Intersect(ray, 0) && !other->Intersect(ray, 0);
  }
  EXPECT_EQ(through, 0);
}

}  // namespace
