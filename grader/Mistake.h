#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "R2/Image.h"
#include "grader/ShadingRules.h"
#include "source/render/RenderSettings.h"
#include "source/scene/Scene.h"

namespace ray::grade {

/// What a mistake does to a finished image of light.
using ImageFilter = R2::Image (*)(const R2::Image&);

/// All that decides an image of light, for mistakes to change: settings, the surface equation and the scene.
class Variant {
 public:
  /// `scene` must outlive the variant.
  Variant(const Scene& scene, const RenderSettings& reference) : settings(reference), original_(scene) {}

  RenderSettings settings;
  ShadingRules rules;
  DepthRules depth;
  const Scene& scene() const { return own_ ? *own_ : original_; }
  bool HasOwnScene() const { return own_.has_value(); }
  /// The copy of the scene, made by the first call. A mistake that changes settings or rules alone does without
  /// one, and is rendered with the accelerator of the original.
  Scene& OwnScene();

 private:
  const Scene& original_;
  std::optional<Scene> own_;
};

/// A mistake that students make: one row of a table of mistakes/. The engine knows of none; a mistake is a change of
/// data, and the image of it is rendered as any other.
struct Mistake {
  const char* name;                          // "no_ambient": for tables
  const char* title;                         // "no ambient light": completes "as with"
  const char* expected;                      // what a correct program does, with its equation
  const char* hint;                          // where to look, which gives no code away
  ImageFilter of_image = nullptr;            // makes it of a finished image alone, so that two images show it
  void (*make)(Variant& variant) = nullptr;  // makes it of the scene; null where the image is enough
};

/// Every mistake, in the order of mistakes/Tables.h.
std::span<const Mistake* const> Mistakes();

}  // namespace ray::grade
