// Modes that show the first surface in displayable colors.
#include "source/integrate/modes/FirstHit.h"

namespace ray {
namespace {

/// The material's own color, unlit; its texture multiplies it.
class Flat : public FirstHit {
  using FirstHit::FirstHit;
  R2::Color Seen(const ShadingPoint& p) const override {
    const Material& m = *p.material;
    if (!m.color) return p.Albedo();
    return m.texture ? *m.color * m.texture->On(p.at, m.texture_scale) : *m.color;
  }
  R2::Color Missed(const R3::Vector& direction) const override { return Background(world().scene(), direction); }
};

/// The normal as a color, (N + 1) / 2.
class NormalColor : public FirstHit {
  using FirstHit::FirstHit;
  R2::Color Seen(const ShadingPoint& p) const override { return {(p.N.x + 1) / 2, (p.N.y + 1) / 2, (p.N.z + 1) / 2}; }
};

/// Texture coordinates as a color: (u, 0, v), with v counted from the upper row of a texture.
class UvColor : public FirstHit {
  using FirstHit::FirstHit;
  R2::Color Seen(const ShadingPoint& p) const override { return {p.at.uv.x, 0, 1 - p.at.uv.y}; }
};

}  // namespace

extern const IntegratorKind flat_kind{"the color of the first surface, unlit", MakeFirstHit<Flat>};
extern const IntegratorKind normal_color_kind{"normal of the first surface as a color, (N + 1) / 2",
                                              MakeFirstHit<NormalColor>};
extern const IntegratorKind uv_color_kind{"texture coordinates of the first surface as a color, (u, 0, v from the top)",
                                          MakeFirstHit<UvColor>};

}  // namespace ray
