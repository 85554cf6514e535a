#include "R3/CsgSolid.h"

namespace R3 {
namespace {

Box BoundsOf(const CsgPart& part, const Box& in_its_frame) {
  if (in_its_frame.IsEmpty()) return {};
  const Box box = part.csg_from_solid * in_its_frame;
  const Vector slack{part.slack, part.slack, part.slack};
  return {box.low - slack, box.high + slack};
}

}  // namespace

CsgSolid::CsgSolid(const CsgPart& of, std::uint32_t n)
    : part(&of),
      number(n),
      elements(*of.solid),
      has_one_element(of.solid->Elements() == 1),
      is_in_place(of.csg_from_solid.IsIdentity()),
      center(elements.Bounds().Center()),
      radius(elements.Bounds().Radius()),
      reach(Reach(elements.Bounds())),
      bounds(BoundsOf(of, elements.Bounds())) {}

// A shape's own error is 32 u (D + size), and D is at most twice the largest coordinates. Moving the line into the
// solid's frame and the box out of it takes six roundings per number. The sum is less than 256 u of the magnitudes.
CsgSolid::Pad CsgSolid::PadOfCrossings() const {
  const Matrix &out = part->csg_from_solid.Forward(), &in = part->csg_from_solid.Inverse();
  const double stretch = MaxRowSum(out), squeeze = MaxRowSum(in);
  const double in_frame = squeeze * Reach(bounds) + MaxTranslation(in) + reach;
  constexpr double share = 256 * unit_roundoff;
  return {share * (stretch * in_frame + MaxTranslation(out)), share * stretch * squeeze};
}

}  // namespace R3
