#include "source/integrate/CameraRays.h"

#include "source/sample/Warp.h"

namespace ray {
namespace {

// The child of a pixel's key that its tree of rays grows from.
constexpr std::uint64_t tree_key = 1;

}  // namespace

CameraRays::CameraRays(const Camera& camera, const CameraEffects& effects, bool things_move, int width, int height,
                       SamplerKind sampler, std::uint32_t samples)
    : camera_(camera),
      effects_(effects),
      has_time_(things_move || effects.HasMotion()),
      width_(width),
      height_(height),
      sampler_(sampler),
      samples_(samples),
      kernel_(effects.HasLens() ? (has_time_ ? &CameraRays::At<true, true> : &CameraRays::At<true, false>)
                                : (has_time_ ? &CameraRays::At<false, true> : &CameraRays::At<false, false>)) {}

const char* CameraRays::Kernel() const {
  if (effects_.HasLens()) return has_time_ ? "moving lens" : "lens";
  return has_time_ ? "moving pinhole" : "pinhole";
}

template <bool has_lens, bool has_time>
CameraSample CameraRays::At(int column, int row, const RandomKey& pixel, std::uint32_t index) const {
  constexpr std::size_t dimensions = 2 + (has_lens ? 2 : 0) + (has_time ? 1 : 0);
  CameraSample sample;
  sample.index = {pixel.Child(tree_key), index, has_lens || has_time ? static_cast<int>(dimensions) : 0};
  const Points points(sampler_, sample.index.key.Child(camera_key), samples_);
  std::array<double, dimensions> random{0.5, 0.5};
  if (samples_ > 1 || dimensions > 2) {
    random = points.Get<dimensions>(index);
    if (samples_ == 1) random[0] = random[1] = 0.5;
  }
  sample.x = column + random[0];
  sample.y = row + random[1];
  sample.ray = camera_.Through(sample.x, sample.y, width_, height_);
  if constexpr (has_lens) {
    // The direction's part along the axis is 1, so the plane that is sharp is `focus` directions away.
    const R2::Point on_lens = OnDisc({random[2], random[3]});
    const R3::Vector aside = effects_.aperture * (on_lens.x * camera_.right + on_lens.y * camera_.up);
    sample.ray.origin = sample.ray.origin + aside;
    sample.ray.direction = sample.ray.direction - aside / effects_.focus;
  }
  if constexpr (has_time) {
    sample.ray.time = random[dimensions - 1];
    sample.ray.origin = sample.ray.origin + sample.ray.time * effects_.motion;
  }
  return sample;
}

}  // namespace ray
