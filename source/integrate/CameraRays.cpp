#include "source/integrate/CameraRays.h"

#include <cmath>
#include <numbers>

#include "R1/Elementary.h"
#include "R3/Warp.h"

namespace ray {
namespace {

// The child of a pixel's key that its tree of rays grows from.
constexpr std::uint64_t tree_key = 1;

/// Spirals belong to places that are known ahead.
CameraEffects WithRandomLens(CameraEffects effects) {
  effects.lens = LensPattern::random;
  return effects;
}

/// The middle of one of side x side equal parts of a pixel, counted from its lower left corner in rows.
R2::Point OnGrid(std::uint32_t index, std::uint32_t side) {
  return {(index % side + 0.5) / side, (index / side % side + 0.5) / side};
}

/// Number `index` of `count` points that fill the unit disc evenly.
///   source   Vogel, A better way to construct the sunflower head (1979): radius sqrt(n), angle n times the golden one
R2::Point OnSpiral(double index, double turn, int count) {
  constexpr double golden_turn = 2 - std::numbers::phi;
  const double radius = std::sqrt(index / count);
  const auto [sine, cosine] = R1::SinCosTurns(turn * golden_turn);
  return {radius * cosine, radius * sine};
}

}  // namespace

CameraRays::CameraRays(const Camera& camera, const CameraEffects& effects, bool things_move, int width, int height,
                       SamplerKind sampler, std::uint32_t samples)
    : camera_(camera),
      effects_(sampler == SamplerKind::grid ? effects : WithRandomLens(effects)),
      has_time_(things_move || effects.HasMotion()),
      width_(width),
      height_(height),
      half_size_{camera.HalfWidth(), camera.HalfHeight(width, height)},
      sampler_(sampler),
      samples_(samples),
      grid_side_(GridSide(samples / effects_.SamplesOfOnePlace())),
      kernel_(effects.HasLens() ? (has_time_ ? &CameraRays::At<true, true> : &CameraRays::At<true, false>)
                                : (has_time_ ? &CameraRays::At<false, true> : &CameraRays::At<false, false>)) {}

const char* CameraRays::Kernel() const {
  if (effects_.HasLens()) return has_time_ ? "moving lens" : "lens";
  return has_time_ ? "moving pinhole" : "pinhole";
}

/// In the unit disc. The spirals of places that follow each other in a row are turned and grown against each other, so
/// that their points together are even too.
R2::Point CameraRays::OnLens(int column, int row, std::uint32_t index, const R2::Point& random) const {
  if (effects_.lens == LensPattern::random) return R3::OnDisc(random);
  const std::uint32_t n = index % effects_.SamplesOfOnePlace();
  if (effects_.lens == LensPattern::fixed_spiral) return OnSpiral(n, n, effects_.lens_samples);
  const double pixel = static_cast<double>(height_ - 1 - row) * width_ + column;
  const double place = pixel * grid_side_ * grid_side_ + index / effects_.SamplesOfOnePlace();
  const double grown = place * std::numbers::phi;
  return OnSpiral(n + (grown - std::floor(grown)), n + place, effects_.lens_samples);
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
  if (sampler_ == SamplerKind::grid) {
    const R2::Point place = OnGrid(index / effects_.SamplesOfOnePlace(), grid_side_);
    random[0] = place.x, random[1] = place.y;
  }
  sample.x = column + random[0];
  sample.y = row + random[1];
  sample.ray = camera_.Through(sample.x, sample.y, width_, height_, half_size_);
  if constexpr (has_lens) {
    // The direction's part along the axis is 1, so the plane that is sharp is `focus` directions away.
    const R2::Point on_lens = OnLens(column, row, index, {random[2], random[3]});
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
