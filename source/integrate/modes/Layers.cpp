// The modes that show what is known of the first surface, as numbers; see source/render/Layer.h.
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
extern const IntegratorKind normal_kind{"its shading normal on the viewer's side", MakeFirstHit<NormalLayer>};
extern const IntegratorKind uv_kind{"its texture coordinates", MakeFirstHit<UvLayer>};
extern const IntegratorKind albedo_kind{"what it scatters: kd, kr and kt", MakeFirstHit<AlbedoLayer>};
extern const IntegratorKind id_kind{"the number of its primitive", MakeFirstHit<IdLayer>};

}  // namespace ray
