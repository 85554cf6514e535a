#pragma once

#include <optional>
#include <span>

#include "R2/Image.h"
#include "grader/ShadingRules.h"
#include "source/render/RenderSettings.h"
#include "source/scene/Scene.h"

namespace ray::grade {

/// The effect of a mistake on a finished image of light.
using ImageFilter = R2::Image (*)(const R2::Image&);

/// Everything that determines an image of light, for mistakes to change: settings, the surface equation and the scene.
class Variant {
 public:
  /// `scene` must outlive the variant.
  Variant(const Scene& scene, const RenderSettings& reference) : settings(reference), original_(scene) {}

  RenderSettings settings;
  ShadingRules rules;
  DepthRules depth;
  const Scene& scene() const { return own_ ? *own_ : original_; }
  bool HasOwnScene() const { return own_.has_value(); }
  /// Returns the copy of the scene, which the first call creates. A mistake that changes only settings or rules does
  /// not need one, and is rendered with the accelerator of the original.
  Scene& OwnScene();

 private:
  const Scene& original_;
  std::optional<Scene> own_;
};

/// A mistake that students make: one row of a table of mistakes/. The engine does not know mistakes: a mistake is a
/// change of data, and its image is rendered like any other.
struct Mistake {
  const char* name;                          // for tables: "no_ambient"
  const char* title;                         // "no ambient light": completes "as with"
  const char* expected;                      // the behavior of a correct program, with its equation
  const char* hint;                          // a suggestion where to look, without revealing code
  // applies the mistake to a finished image, so that two images alone show it
  ImageFilter of_image = nullptr;
  // applies the mistake to the scene; null if `of_image` suffices
  void (*make)(Variant& variant) = nullptr;
};

/// Returns every mistake, in the order of mistakes/Tables.h.
std::span<const Mistake* const> Mistakes();

}  // namespace ray::grade
