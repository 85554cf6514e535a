#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "R2/Image.h"
#include "R2/compare/Difference.h"
#include "source/accelerate/AcceleratorSettings.h"
#include "grader/Mistake.h"
#include "grader/Suite.h"

namespace ray::grade {

/// A scene to be rendered: read from its file, with its own settings and those of the suite applied.
struct SceneToRender {
  Scene scene;
  RenderSettings settings;
  AcceleratorSettings accelerator;
};
/// Reads a scene; throws SceneErrors. The available options are defined above this layer.
using Loader = std::function<SceneToRender(const SuiteScene& scene, const std::string& file)>;

/// Returns the largest |channel|.
inline double LargestChannel(const R2::Color& c) { return std::max({std::abs(c.r), std::abs(c.g), std::abs(c.b)}); }

/// Mistakes that were made together, in this order.
using MistakeList = std::vector<const Mistake*>;

/// The reference image of a scene, its reliable pixels, and the images with mistakes, which are rendered on demand.
class SceneImages {
 public:
  /// `file`: the scene, or its variation by a seed.
  SceneImages(const SuiteScene& scene, const std::string& file, const Loader& load);
  ~SceneImages();

  const SuiteScene& scene() const { return scene_; }
  /// Returns displayed values, in 0..1.
  const R2::Image& Reference() const { return reference_; }
  /// Returns the steady pixels, in rows from the bottom. A pixel is steady unless it changes by more than the tolerance
  /// when the camera is moved by half a pixel, several surfaces are coincident there, or a blended normal points away.
  const std::vector<bool>& Steady() const { return steady_; }
  /// Returns the change of the reference within each pixel: programs put their samples anywhere in it.
  const std::vector<double>& Spread() const { return spread_; }
  /// Returns the references of programs whose rays go through the four corners of pixels, if pixels are compared.
  const std::vector<R2::Image>& Corners() const { return corners_; }
  /// Returns the change of the image with mistakes within each pixel; of the reference if they do not apply.
  std::vector<double> SpreadWith(const MistakeList& mistakes);
  /// Returns the image with mistakes, as displayed; std::nullopt if they do not apply to this scene.
  std::optional<R2::Image> With(const MistakeList& mistakes);
  /// Returns the same before values are clamped.
  std::optional<R2::Image> LightWith(const MistakeList& mistakes);
  /// Returns the image with mistakes as another program may show it: with the camera shifted by a tenth of a pixel, in
  /// bytes. Empty if the mistakes do not apply.
  R2::Image AsOfAnother(const MistakeList& mistakes) const;
  /// Returns the values that are compared: the image itself, or, if programs sample at random, means of blocks.
  R2::Image Cells(const R2::Image& image) const;
  int CellSide() const { return scene_.runs > 1 ? 8 : 1; }
  /// Returns the tree of our rays at a pixel, in lines.
  std::string RayTreeAt(int x, int y) const;

 private:
  struct Built;
  /// Renders an image; empty if the mistakes, which must all be applied before rendering, do not apply.
  R2::Image Light(const MistakeList& mistakes, R2::Vector shift_in_pixels = {}) const;
  /// Throws SceneErrors if an option of the suite does not change the image.
  void RefuseIdleOptions(const Loader& load);
  /// Returns the images of rays through the four corners of pixels.
  std::vector<R2::Image> CornersWith(const MistakeList& mistakes) const;
  void FindSteadyPixels();

  const SuiteScene& scene_;
  std::string file_;
  std::unique_ptr<Built> built_;
  R2::Image reference_;
  std::vector<bool> steady_;
  std::vector<double> spread_;
  std::vector<R2::Image> corners_;
  std::map<MistakeList, std::vector<double>> spread_with_;
  // The inputs of mistakes of the finished image.
  std::map<MistakeList, R2::Image> light_;
};

}  // namespace ray::grade
