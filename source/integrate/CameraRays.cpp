#include "source/integrate/CameraRays.h"

#include <cmath>
#include <numbers>

#include "R1/Elementary.h"
#include "R3/Numeric.h"
#include "R3/Warp.h"
#include "source/sample/PointBatch.h"
#include "source/sample/PoissonDisk.h"

namespace ray {
namespace {

// The child of a pixel's key for the tree of its rays.
constexpr std::uint64_t tree_key = 1;
// The child of a pixel's key for the places of the Poisson pattern.
constexpr std::uint64_t poisson_key = 2;

/// Returns the effects without spirals and even moments, which require places that are known in advance.
CameraEffects WithRandomChoices(CameraEffects effects) {
  effects.lens = LensPattern::random;
  effects.shutter_samples = 1;
  return effects;
}

/// Returns the middle of one of side x side equal parts of a pixel, counted from its lower left corner in rows.
R2::Point OnGrid(std::uint32_t index, std::uint32_t side) {
  return {(index % side + 0.5) / side, (index / side % side + 0.5) / side};
}

/// Returns OnGrid with each place shifted by a fraction of its row or column: again a square grid, rotated by atan(1 /
/// side), with one place per row and per column.
///   source   Akenine-Moeller, Haines and others, Real-time rendering (2018), section 5.4.2, where side is 2
R2::Point OnRotatedGrid(std::uint32_t index, std::uint32_t side) {
  const std::uint32_t column = index % side, row = index / side % side;
  return {(column + (row + 0.5) / side) / side, (row + (side - 1 - column + 0.5) / side) / side};
}

/// Returns point number `index` of `count` points that fill the unit disc evenly.
///   source   Vogel, A better way to construct the sunflower head (1979): radius sqrt(n), angle n times the golden one
R2::Point OnSpiral(double index, double turn, int count) {
  constexpr double golden_turn = 2 - std::numbers::phi;
  const double radius = std::sqrt(index / count);
  const auto [sine, cosine] = R1::SinCosTurns(turn * golden_turn);
  return {radius * cosine, radius * sine};
}

/// Computes places in the pixel that keep a distance from those of the pixel's other samples.
void PutApart(std::span<const PixelSample> of, double* x, double* y) {
  for (std::size_t i = 0; i < of.size(); ++i) {
    const R2::Point p = PoissonDiskPlace(of[i].index, of[i].pixel.Child(poisson_key));
    x[i] = p.x, y[i] = p.y;
  }
}

/// Maps places of the unit square to the unit disc.
R3_VECTORIZED
void PutOnDisks(std::size_t count, double* x, double* y) {
  for (std::size_t i = 0; i < count; ++i) {
    const R2::Point p = R3::SampleUniformDiskConcentric({x[i], y[i]});
    x[i] = p.x, y[i] = p.y;
  }
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
      kernel_(camera.IsPinhole() ? KernelFor<true>() : KernelFor<false>()) {}

template <bool is_pinhole>
CameraRays::MakeSamples CameraRays::KernelFor() const {
  if (effects_.HasLens())
    return has_time_ ? &CameraRays::Make<is_pinhole, true, true> : &CameraRays::Make<is_pinhole, true, false>;
  return has_time_ ? &CameraRays::Make<is_pinhole, false, true> : &CameraRays::Make<is_pinhole, false, false>;
}

std::string CameraRays::Kernel() const {
  const std::string kind = camera_.kind->name, moving = has_time_ ? "moving " : "";
  if (!effects_.HasLens()) return moving + kind;
  return moving + (camera_.IsPinhole() ? "lens" : kind + " lens");
}

/// Returns a place in [0, 1]^2. A single sample goes through the middle.
R2::Point CameraRays::InPixel(std::uint32_t index, const R2::Point& random) const {
  const std::uint32_t number = index / effects_.SamplesOfOnePlace();
  if (sampler_ == SamplerKind::grid) return OnGrid(number, grid_side_);
  if (sampler_ == SamplerKind::rotated_grid) return OnRotatedGrid(number, grid_side_);
  return samples_ == 1 ? R2::Point{0.5, 0.5} : random;
}

/// Returns a place in the unit disc; `random` is one already. The spirals of successive places in a row are rotated and
/// scaled relative to each other, so that their points are evenly distributed together.
R2::Point CameraRays::OnLens(const PixelSample& of, const R2::Point& random) const {
  if (effects_.lens == LensPattern::random) return random;
  const std::uint32_t n = of.index % effects_.SamplesOfOnePlace() % static_cast<std::uint32_t>(effects_.lens_samples);
  if (effects_.lens == LensPattern::fixed_spiral) return OnSpiral(n, n, effects_.lens_samples);
  const double pixel = static_cast<double>(height_ - 1 - of.row) * width_ + of.column;
  const double place = pixel * grid_side_ * grid_side_ + of.index / effects_.SamplesOfOnePlace();
  const double grown = place * std::numbers::phi;
  return OnSpiral(n + (grown - std::floor(grown)), n + place, effects_.lens_samples);
}

/// Returns a time in [0, 1): random, or the middle of one of the shutter's equal parts. Each part is combined with all
/// places on the lens.
double CameraRays::Moment(std::uint32_t index, double random) const {
  if (effects_.shutter_samples <= 1) return random;
  const auto moments = static_cast<std::uint32_t>(effects_.shutter_samples);
  const std::uint32_t each = effects_.SamplesOfOnePlace(), lens = each / moments;
  return (index % each / lens + 0.5) / moments;
}

/// Moves the origin of a ray from the lens's center to a place on the lens. The direction's component along the axis is
/// 1, so the plane in focus is `focus` directions away; in other projections their directions define it.
void CameraRays::MoveOnLens(const R2::Point& on_lens, const R3::Vector& across, const R3::Vector& upward,
                            R3::Ray& ray) const {
  const R3::Vector aside = effects_.aperture * (on_lens.x * across + on_lens.y * upward);
  ray.origin = ray.origin + aside;
  ray.direction = ray.direction - aside / effects_.focus;
}

/// Returns the ray of a camera that is not a pinhole. `on_lens`: in the unit disc; its center without a lens.
R3::Ray CameraRays::Projected(const CameraSample& at, const R2::Point& on_lens) const {
  const auto sight = camera_.Sight(at.x, at.y, width_, height_);
  if (!sight) return {camera_.eye, camera_.towards, 0, 0};
  R3::Ray ray{sight->origin, sight->direction};
  if (effects_.HasLens()) MoveOnLens(on_lens, sight->across, sight->upward, ray);
  return ray;
}

template <bool is_pinhole, bool has_lens, bool has_time>
void CameraRays::Make(std::span<const PixelSample> of, std::span<CameraSample> samples) const {
  constexpr std::size_t dimensions = 2 + (has_lens ? 2 : 0) + (has_time ? 1 : 0);
  std::array<SampleIndex, R1::batch_size> indices;
  for (std::size_t i = 0; i < of.size(); ++i)
    indices[i] = {of[i].pixel.Child(tree_key), of[i].index, dimensions > 2 ? static_cast<int>(dimensions) : 0};
  PointBatch<dimensions> random;
  if (dimensions == 2 && samples_ == 1)  // no random choices
    for (auto& coordinate : random.coordinates) coordinate.fill(0.5);
  else
    GetSeparateBatch(std::span<const SampleIndex>(indices).first(of.size()), camera_key, sampler_, samples_, random);
  if (sampler_ == SamplerKind::poisson && samples_ > 1)
    PutApart(of, random.coordinates[0].data(), random.coordinates[1].data());
  if constexpr (has_lens) PutOnDisks(of.size(), random.coordinates[2].data(), random.coordinates[3].data());
  for (std::size_t i = 0; i < of.size(); ++i) {
    CameraSample& sample = samples[i];
    sample.index = indices[i];
    const R2::Point in_pixel = InPixel(of[i].index, random.Get2D(i));
    sample.x = of[i].column + in_pixel.x, sample.y = of[i].row + in_pixel.y;
    R2::Point on_lens;
    if constexpr (has_lens) on_lens = OnLens(of[i], {random.coordinates[2][i], random.coordinates[3][i]});
    if constexpr (is_pinhole) {
      sample.ray = camera_.Through(sample.x, sample.y, width_, height_, half_size_);
      if constexpr (has_lens) MoveOnLens(on_lens, camera_.right, camera_.up, sample.ray);
    } else {
      sample.ray = Projected(sample, on_lens);
    }
    if constexpr (has_time) {
      sample.ray.time = Moment(of[i].index, random.coordinates[dimensions - 1][i]);
      sample.ray.origin = sample.ray.origin + sample.ray.time * effects_.motion;
    }
  }
}

}  // namespace ray
