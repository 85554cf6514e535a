#include "source/integrate/modes/Outlined.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "source/integrate/debug/RayRecorder.h"

namespace ray {
namespace {

// A jump in depth: the relative second difference of 1 / depth. On a plane it is 0 at any slant, since 1 / depth is
// linear in the image. 1/30 is the value at which a ball with a radius of 100 pixels, seen at 45 degrees in 400 pixels,
// curves away from the eye between its last two pixels. A larger value would thin no line, a smaller one would thicken
// that ball's.
constexpr double least_jump = 1.0 / 30;
// A crease: normals 30 degrees apart. On a ball, neighboring pixels differ by that only at its rim, if its radius is
// above 2 / (30 degrees)^2 = 7.3 pixels.
constexpr double cosine_of_crease = 0.8660254037844386;

/// The result of a ray next to a camera ray.
struct Glance {
  double nearness = 0;  // 1 / depth, depth in lengths of the camera's axis; 0 without a surface
  R3::Vector N;         // unit, on the viewer's side, without bump maps: relief has no outlines
};

class Outlined : public Integrator {
 public:
  Outlined(std::unique_ptr<const Integrator> inner, const World& world, const Accelerator& accelerator,
           const OutlineSettings& outline)
      : inner_(std::move(inner)), world_(world), accelerator_(accelerator), outline_(outline) {
    const R3::Vector right = outline.width / 2 * outline.right, up = outline.width / 2 * outline.up;
    asides_ = {right, -right, up, -up};
  }

  void Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const override {
    // Camera rays are recorded before the rays that come from their ends.
    const std::size_t first_record = state.recorder ? state.recorder->Rays().size() : 0;
    inner_->Li(samples, radiances, state);
    for (std::size_t i = 0; i < samples.size() && !state.IsStopped(); ++i) {
      if (!IsOnLine(samples[i], state)) continue;
      radiances[i] = {};
      if (state.recorder) state.recorder->OnOutline(static_cast<int>(first_record + i));
    }
  }

 private:
  Glance Look(const R3::Ray& ray, TraceState& state) const {
    const auto hit = accelerator_.Intersect(ray, state.workspace);
    state.Count(RayKind::camera, 1);
    if (!hit) return {};
    const R3::Vector n = AsVector(world_.At(ray, *hit).shading_normal);
    return {1 / hit->t, Dot(n, ray.direction) <= 0 ? n : -n};
  }

  /// Returns ray number `i` next to that of a sample; std::nullopt if it is outside of the camera's view.
  std::optional<R3::Ray> Beside(const CameraSample& sample, std::size_t i) const {
    R3::Ray aside = sample.ray;
    if (outline_.camera.IsPinhole()) {
      aside.direction = aside.direction + asides_[i];
      return aside;
    }
    static constexpr std::array<R2::Vector, 4> ways{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    const auto sight = [&](double pixels) {
      return outline_.camera.Sight(sample.x + pixels * ways[i].x, sample.y + pixels * ways[i].y, outline_.image_width,
                                   outline_.image_height);
    };
    const auto here = sight(0), there = sight(outline_.width / 2);
    if (!here || !there) return {};
    aside.origin = aside.origin + (there->origin - here->origin);
    aside.direction = aside.direction + (there->direction - here->direction);
    return aside;
  }

  bool IsOnLine(const CameraSample& sample, TraceState& state) const {
    const Glance middle = Look(sample.ray, state);
    std::array<Glance, 4> beside;
    for (std::size_t i = 0; i < beside.size(); ++i) {
      const auto aside = Beside(sample, i);
      beside[i] = aside ? Look(*aside, state) : middle;
      const bool are_surfaces = middle.nearness > 0 && beside[i].nearness > 0;
      if (are_surfaces && Dot(middle.N, beside[i].N) < cosine_of_crease) return true;
    }
    const auto jumps = [&](const Glance& a, const Glance& b) {
      const double most = std::max({a.nearness, b.nearness, middle.nearness});
      return std::abs(a.nearness - 2 * middle.nearness + b.nearness) > least_jump * most;
    };
    return jumps(beside[0], beside[1]) || jumps(beside[2], beside[3]);
  }

  std::unique_ptr<const Integrator> inner_;
  const World& world_;
  const Accelerator& accelerator_;
  const OutlineSettings outline_;
  std::array<R3::Vector, 4> asides_;  // differences of a pinhole's directions, opposite ones together
};

}  // namespace

std::unique_ptr<const Integrator> WithOutlines(std::unique_ptr<const Integrator> inner, const World& world,
                                               const Accelerator& accelerator, const OutlineSettings& outline) {
  return std::make_unique<Outlined>(std::move(inner), world, accelerator, outline);
}

}  // namespace ray
