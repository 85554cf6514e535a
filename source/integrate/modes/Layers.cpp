// Modes that show properties of the first surface as numbers; see source/render/Layer.h.
#include "source/integrate/modes/FirstHit.h"

namespace ray {
namespace {

class DepthLayer : public FirstHit {
  using FirstHit::FirstHit;
  R2::Color Seen(const ShadingPoint& p) const override {
    const double distance = DistanceFromEye(p);
    return {distance, distance, distance};
  }
};

class NormalLayer : public FirstHit {
  using FirstHit::FirstHit;
  R2::Color Seen(const ShadingPoint& p) const override { return {p.N.x, p.N.y, p.N.z}; }
};

class UvLayer : public FirstHit {
  using FirstHit::FirstHit;
  R2::Color Seen(const ShadingPoint& p) const override { return {p.at.uv.x, p.at.uv.y, 0}; }
};

class AlbedoLayer : public FirstHit {
  using FirstHit::FirstHit;
  R2::Color Seen(const ShadingPoint& p) const override { return p.Albedo(); }
  R2::Color Missed(const R3::Vector& direction) const override { return Background(world().scene(), direction); }
};

class IdLayer : public FirstHit {
  using FirstHit::FirstHit;
  R2::Color Seen(const ShadingPoint& p) const override {
    const auto id = static_cast<double>(world().PrimitiveId(p.hit));
    return {id, id, id};
  }
  R2::Color Missed(const R3::Vector&) const override { return {-1, -1, -1}; }
};

}  // namespace

extern const IntegratorKind depth_kind{"distance to the first surface", MakeFirstHit<DepthLayer>};
extern const IntegratorKind normal_kind{"shading normal of the first surface on the viewer's side",
                                        MakeFirstHit<NormalLayer>};
extern const IntegratorKind uv_kind{"texture coordinates of the first surface", MakeFirstHit<UvLayer>};
extern const IntegratorKind albedo_kind{"reflectance of the first surface: kd, kr and kt", MakeFirstHit<AlbedoLayer>};
extern const IntegratorKind id_kind{"primitive number of the first surface", MakeFirstHit<IdLayer>};

}  // namespace ray
