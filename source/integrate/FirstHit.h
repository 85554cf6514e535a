#pragma once

#include "source/integrate/Integrator.h"

namespace ray {

/// What is known of the first surface that a camera ray meets.
///   depth    distance from the eye to it, in all channels; 0 where there is none
///   normal   its shading normal x y z in the world, on the viewer's side; 0 0 0 where there is none
///   uv       its texture coordinates in the first two channels
///   albedo   what it scatters, kd times texture plus ks plus kt; the background's where there is none
///   id       the number of its primitive in the scene, from 0; -1 where there is none
enum class Layer { depth, normal, uv, albedo, id };
inline constexpr std::array layer_names{"depth", "normal", "uv", "albedo", "id"};
constexpr const auto& NamesOf(Layer) { return layer_names; }

/// Shows one layer.
class FirstHit : public Integrator {
 public:
  FirstHit(const World& world, const Accelerator& accelerator, Layer layer)
      : world_(world), accelerator_(accelerator), layer_(layer) {}

  void Li(std::span<const CameraSample> samples, std::span<R2::Color> radiances, TraceState& state) const override;

 private:
  void Record(const CameraSample& sample, const std::optional<WorldHit>& hit, const R2::Color& seen,
              RayRecorder& recorder) const;
  R2::Color Seen(const CameraSample& sample, const std::optional<WorldHit>& hit) const;

  const World& world_;
  const Accelerator& accelerator_;
  Layer layer_;
};

}  // namespace ray
