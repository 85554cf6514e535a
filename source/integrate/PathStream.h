#pragma once

#include "source/integrate/Path.h"
#include "source/sample/PointsOfEach.h"

namespace ray {

/// A vector of each of some paths.
struct VectorOfEach {
  alignas(64) LightSamples::Each x, y, z;

  R3::Vector operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void Set(std::size_t i, const R3::Vector& v) { x[i] = v.x, y[i] = v.y, z[i] = v.z; }
};

/// A color of each of some paths.
struct ColorOfEach {
  alignas(64) LightSamples::Each r, g, b;

  R2::Color operator[](std::size_t i) const { return {r[i], g[i], b[i]}; }
  void Set(std::size_t i, const R2::Color& c) { r[i] = c.r, g[i] = c.g, b[i] = c.b; }
};

/// What Path gives, bit for bit, made of many paths together: all of them take a step before any takes the next, so
/// that each stage of a step is a loop over arrays: random points, places on lights, what surfaces reflect, directions.
/// Rays that are recorded go by Path.
///   source   Laine, Karras, Aila, Megakernels considered harmful: wavefront path tracing on GPUs (2013), for the
///            stages
class PathStream : public Path {
 public:
  using Path::Path;

  void Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const override;

 private:
  /// The surfaces that paths have reached, and the path of each, which is the number of its camera sample.
  struct Front;
  /// What is computed in loops over a front.
  struct Loops;
  /// Of the point of that number in a front.
  struct StepFrom;
  using Steps = std::vector<StepFrom>;
  /// Rays of one lobe are traced together: they are of one kind, and those that mirrors and glass send on go nearly the
  /// same way.
  using StepsByLobe = std::array<Steps, lobes>;

  /// At most R1::batch_size samples.
  void TraceTogether(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const;
  /// Whether all points sample lights of the scene language, which come first.
  bool HasSceneLights() const { return SamplesAllLights() && !lights_.IsEmpty() && lights_.SceneLight(0); }
  /// Light that reaches each point straight from lights goes to state.arrived.
  void LightPoints(const Front& front, TraceState& state) const;
  void AddLight(int light, const Front& front, TraceState& state) const;
  /// Of a lamp whose emission is a color, point by point.
  void AddLamp(int lamp, const Front& front, const PointsOfEach<2>& random, TraceState& state) const;
  /// Of light samples with pdfs, what is reflected.
  void ReflectEach(const Front& front, const LightSamples::Each& pdfs, LightSamples& samples) const;
  /// The same of samples of a light of the scene language.
  void ReflectEachByPhong(const Front& front, LightSamples& samples) const;
  /// To the next surfaces, which come to `next`.
  void TakeStep(const Front& front, std::span<R2::Color> gathered, Front& next, TraceState& state) const;
  StepsByLobe SampleBsdfs(const Front& front) const;
  /// What the rays of these steps, which hit nothing, see.
  void AddBackgrounds(const Front& front, std::span<const StepFrom* const> steps, std::span<R2::Color> gathered,
                      TraceState& state) const;
  /// Of one lobe; what each step's ray hits goes to state.hits.
  void TraceSteps(const Steps& steps, TraceState& state) const;
};

}  // namespace ray
