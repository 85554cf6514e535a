#include "source/integrate/CameraRays.h"

#include <cmath>
#include <numbers>

#include "R1/Elementary.h"
#include "R3/Warp.h"

namespace ray {
namespace {

// The child of a pixel's key that its tree of rays grows from.
constexpr std::uint64_t tree_key = 1;

/// Spirals and even moments belong to places that are known ahead.
CameraEffects WithRandomChoices(CameraEffects effects) {
  effects.lens = LensPattern::random;
  effects.shutter_samples = 1;
  return effects;
}

/// The middle of one of side x side equal parts of a pixel, counted from its lower left corner in rows.
R2::Point OnGrid(std::uint32_t index, std::uint32_t side) {
  return {(index % side + 0.5) / side, (index / side % side + 0.5) / side};
}

/// The same, each place moved on by a part of the rows or columns beside it: a square grid again, turned by
/// atan(1 / side), and every place in a row and a column of its own.
///   source   Akenine-Moeller, Haines and others, Real-time rendering (2018), section 5.4.2, where side is 2
R2::Point OnRotatedGrid(std::uint32_t index, std::uint32_t side) {
  const std::uint32_t column = index % side, row = index / side % side;
  return {(column + (row + 0.5) / side) / side, (row + (side - 1 - column + 0.5) / side) / side};
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
      effects_(IsGrid(sampler) ? effects : WithRandomChoices(effects)),
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
  if (effects_.lens == LensPattern::random) return R3::SampleUniformDiskConcentric(random);
  const std::uint32_t n = index % effects_.SamplesOfOnePlace() % static_cast<std::uint32_t>(effects_.lens_samples);
  if (effects_.lens == LensPattern::fixed_spiral) return OnSpiral(n, n, effects_.lens_samples);
  const double pixel = static_cast<double>(height_ - 1 - row) * width_ + column;
  const double place = pixel * grid_side_ * grid_side_ + index / effects_.SamplesOfOnePlace();
  const double grown = place * std::numbers::phi;
  return OnSpiral(n + (grown - std::floor(grown)), n + place, effects_.lens_samples);
}

/// The middle of one of the shutter's equal parts; each goes with all places on the lens.
double CameraRays::Moment(std::uint32_t index) const {
  const auto moments = static_cast<std::uint32_t>(effects_.shutter_samples);
  const std::uint32_t each = effects_.SamplesOfOnePlace(), lens = each / moments;
  return (index % each / lens + 0.5) / moments;
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
  if (IsGrid(sampler_)) {
    const std::uint32_t number = index / effects_.SamplesOfOnePlace();
    const R2::Point place =
        sampler_ == SamplerKind::grid ? OnGrid(number, grid_side_) : OnRotatedGrid(number, grid_side_);
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
    sample.ray.time = effects_.shutter_samples > 1 ? Moment(index) : random[dimensions - 1];
    sample.ray.origin = sample.ray.origin + sample.ray.time * effects_.motion;
  }
  return sample;
}

}  // namespace ray
