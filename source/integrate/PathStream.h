#pragma once

#include "source/integrate/Path.h"
#include "source/sample/PointsOfEach.h"

namespace ray {

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
  /// The surfaces that paths have reached, and where each path, the camera sample's number, keeps what it gathers.
  struct Front {
    std::vector<ShadingPoint> points;
    std::vector<SampleIndex> indices;  // of the points
    std::vector<std::uint32_t> paths;

    void Add(ShadingPoint&& p, std::uint32_t path) {
      indices.push_back(p.path.index);
      points.push_back(std::move(p));
      paths.push_back(path);
    }
    void Clear() { points.clear(), indices.clear(), paths.clear(); }
  };

  /// At most PointsOfEach<2>::most samples.
  void TraceTogether(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const;
  /// Light that reaches each point straight from lights goes to state.arrived.
  void LightPoints(const Front& front, std::span<const Bsdf> bsdfs, TraceState& state) const;
  void AddExtendedLight(int light, const Front& front, const PointsOfEach<2>& random, TraceState& state) const;
  /// To the next surfaces, which come to `next`.
  void TakeStep(const Front& front, std::span<const Bsdf> bsdfs, std::span<R2::Color> gathered, Front& next,
                TraceState& state) const;
};

}  // namespace ray
