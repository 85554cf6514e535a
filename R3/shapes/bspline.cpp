#include "R3/shapes/BezierPatch.h"

namespace R3 {
namespace {

using Row = std::array<Vector, 4>;

/// Converts the control points of a uniform cubic B-spline to Bernstein's basis. Each is off by at most 5 u of the
/// largest coordinate: a product, two sums and a quotient, each rounded.
///   source   Farin, Curves and Surfaces for CAGD (2002), section 8.3
Row InBernsteinBasis(const Row& p) {
  return {(p[0] + 4 * p[1] + p[2]) / 6, (2 * p[1] + p[2]) / 3, (p[1] + 2 * p[2]) / 3, (p[1] + 4 * p[2] + p[3]) / 6};
}

/// Converts along rows first, then across them: neighbors with three common rows or columns of points get a
/// bit-identical edge.
patch::Net<Vector> NetInBernsteinBasis(const patch::Net<Vector>& net) {
  patch::Net<Vector> rows, patch;
  for (std::size_t j = 0; j < 4; ++j) rows[j] = InBernsteinBasis(net[j]);
  for (std::size_t i = 0; i < 4; ++i) {
    const Row column = InBernsteinBasis(Row{rows[0][i], rows[1][i], rows[2][i], rows[3][i]});
    for (std::size_t j = 0; j < 4; ++j) patch[j][i] = column[j];
  }
  return patch;
}

}  // namespace

extern const ShapeKind bspline_kind{
    "bspline",
    "a bicubic patch of a uniform B-spline surface by 16 control points, four rows of four: u grows along a row, v "
    "from row to row; patches that share twelve points join smoothly",
    PatchArguments(),
    [](std::span<const double> a) {
      return BezierPatch(NetInBernsteinBasis(PatchNet(a)), Recipe{"bspline", {a.begin(), a.end()}});
    },
    {-3, -1, -3, -1.2, 1, -3.1, 0.9, -1, -3, 3, 1, -3, -3.1, -0.9, -1.2, -0.9,
     1.1, -0.9, 1.2, -0.9, -0.9, 3.1, 1.1, -1.2, -3, -0.8, 0.9, -1.2, 1.2, 1.2, 0.9, -0.8,
     0.9, 3, 1.2, 1.2, -3, -0.7, 3, -0.9, 1.3, 3.1, 1.2, -0.7, 3, 3, 1.3, 3},
};

}  // namespace R3
