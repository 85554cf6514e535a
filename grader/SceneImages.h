#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "R2/Image.h"
#include "R2/compare/Difference.h"
#include "source/accelerate/AcceleratorSettings.h"
#include "grader/Mistake.h"
#include "grader/Suite.h"

namespace ray::grade {

/// A scene as it is to be rendered: read from its file, with its own settings and those of the suite in force.
struct SceneToRender {
  Scene scene;
  RenderSettings settings;
  AcceleratorSettings accelerator;
};
/// Reads a scene; throws SceneErrors. Which options there are is known above this layer.
using Loader = std::function<SceneToRender(const SuiteScene& scene, const std::string& file)>;

/// The largest |channel|.
inline double LargestChannel(const R2::Color& c) { return std::max({std::abs(c.r), std::abs(c.g), std::abs(c.b)}); }

/// Mistakes that were made together, in this order.
using MistakeList = std::vector<const Mistake*>;

/// The reference image of a scene, which of its pixels can be relied on, and the images that mistakes make of it. Those
/// are rendered when they are first asked for.
class SceneImages {
 public:
  /// `file`: the scene, or what a seed has made of it.
  SceneImages(const SuiteScene& scene, const std::string& file, const Loader& load);
  ~SceneImages();

  const SuiteScene& scene() const { return scene_; }
  /// Values for a screen, in 0..1.
  const R2::Image& Reference() const { return reference_; }
  /// By rows from the bottom. A pixel is steady unless it changes by more than the tolerance when the camera is moved
  /// by less than half a pixel, or several surfaces are coincident there.
  const std::vector<bool>& Steady() const { return steady_; }
  /// Returns which pixels of the image with mistakes are steady in the same way; all of them where it cannot be made.
  std::vector<bool> SteadyWith(const MistakeList& mistakes);
  /// How far smoothed edges may be from the reference at each pixel: programs differ in where their samples lie.
  const std::vector<double>& Smoothing() const { return smoothing_; }
  /// Returns the image with mistakes, values for a screen; nothing where they cannot be made in this scene.
  std::optional<R2::Image> With(const MistakeList& mistakes);
  /// Returns the same before values are clamped.
  std::optional<R2::Image> LightWith(const MistakeList& mistakes);
  /// With mistakes, as another program may show it: from a camera a tenth of a pixel aside, in bytes. Empty where the
  /// mistakes cannot be made.
  R2::Image AsOfAnother(const MistakeList& mistakes) const;
  /// The images as they are compared: as they are, or, where programs sample at random, means of blocks.
  R2::Image Cells(const R2::Image& image) const;
  int CellSide() const { return scene_.runs > 1 ? 8 : 1; }
  /// What our rays do at a pixel, in lines.
  std::string RayTreeAt(int x, int y) const;

 private:
  struct Built;
  /// Empty where the mistakes, all of them made before an image is rendered, cannot be made; samples 0: as many as the
  /// scene asks for.
  R2::Image Light(const MistakeList& mistakes, R2::Vector shift_in_pixels = {}, int samples = 0) const;
  /// Throws SceneErrors if an option of the suite does not change the image.
  void RefuseIdleOptions(const Loader& load);
  void FindSteadyPixels();
  void FindSmoothing();

  const SuiteScene& scene_;
  std::string file_;
  std::unique_ptr<Built> built_;
  R2::Image reference_;
  std::vector<bool> steady_;
  std::vector<double> smoothing_;
  std::map<MistakeList, std::vector<bool>> steady_with_;
  // What mistakes of the finished image begin with.
  std::map<MistakeList, R2::Image> light_;
};

}  // namespace ray::grade
