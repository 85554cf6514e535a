#include "source/inspect/RayInspector.h"

#include <algorithm>

namespace ray {

void RayInspector::TraceGrid(const LoadedScene& scene, const RenderSettings& settings) {
  grid_ = ray::TraceGrid(scene.world, *scene.accelerator, counts_.Thinned(settings));
  shows_grid_ = true;
}

void RayInspector::TracePixel(const LoadedScene& scene, const RenderSettings& settings, int column, int row) {
  pixel_settings_ = settings;
  look_.chosen.reset();
  ++trace_number_;
  pixel_ = PixelTracer(scene.world, *scene.accelerator, counts_.Thinned(settings))
               .Trace(column, row, counts_.SamplesOf(settings));
  difference_.reset();
  if (foreign_.empty()) return;
  RenderSettings through_middle = settings;
  through_middle.trace.sampler = SamplerKind::grid;
  through_middle.samples = 1;
  difference_ = FirstDifference(PixelTracer(scene.world, *scene.accelerator, through_middle).Trace(column, row, 1),
                                foreign_, scene.world, through_middle);
}

void RayInspector::TraceAgain(const LoadedScene& scene) {
  if (pixel_) TracePixel(scene, pixel_settings_, pixel_->column, pixel_->row);
}

bool RayInspector::StepPixel(const LoadedScene& scene, int right, int up) {
  if (!pixel_) return false;
  const int column = pixel_->column + right, row = pixel_->row + up;
  if (column < 0 || row < 0 || column >= pixel_settings_.width || row >= pixel_settings_.height) return false;
  TracePixel(scene, pixel_settings_, column, row);
  return true;
}

void RayInspector::StepBounce(int by) {
  int deepest = 0;
  for (const PixelTrace& trace : Shown())
    for (const RecordedRay& ray : trace.rays) deepest = std::max(deepest, ray.depth);
  // Round and round: all bounces, then none, one, two...
  look_.deepest += by;
  if (look_.deepest >= deepest) look_.deepest = -1;
  if (look_.deepest < -1) look_.deepest = deepest - 1;
}

std::string RayInspector::WhatIsLeftOut() const {
  const int samples = pixel_settings_.samples, shadows = pixel_settings_.trace.shadow_samples;
  std::string text;
  if (counts_.camera < samples)
    text += ", " + std::to_string(counts_.camera) + " of " + std::to_string(samples) + " samples";
  if (counts_.shadow < shadows)
    text += ", " + std::to_string(counts_.shadow) + " of " + std::to_string(shadows) + " shadow rays to an area light";
  return text;
}

void RayInspector::ForgetAll() {
  grid_.clear();
  ForgetPixel();
}

std::vector<PixelTrace> RayInspector::Shown() const {
  std::vector<PixelTrace> shown;
  if (shows_grid_) shown = grid_;
  if (pixel_) shown.push_back(*pixel_);
  return shown;
}

}  // namespace ray
