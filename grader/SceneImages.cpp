#include "grader/SceneImages.h"

#include <algorithm>
#include <iterator>

#include "R2/ImageFile.h"
#include "source/accelerate/Accelerator.h"
#include "grader/RuledDepth.h"
#include "grader/RuledShading.h"
#include "source/render/PixelTrace.h"
#include "source/render/Render.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray::grade {
namespace {

// The corners of a pixel: a straight edge that crosses it separates one of them from its middle. So programs may put
// their samples anywhere within it.
constexpr R2::Vector shifts[]{{-0.5, -0.5}, {0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}};

/// Moves the camera slightly, so that the whole image moves by that many pixels.
void Shift(Variant& variant, R2::Vector pixels) {
  if (pixels == R2::Vector{}) return;
  RenderSettings& settings = variant.settings;
  if (!settings.view) settings.view = variant.scene().camera;
  R2::Vector& shift = settings.view->shift;
  const double pixel = 2.0 / settings.width;
  shift = {shift.x + pixel * pixels.x, shift.y + pixel * pixels.y};
}

/// Applies mistakes of the finished image to an image of light.
R2::Image Finished(R2::Image image, const MistakeList& mistakes) {
  for (const Mistake* mistake : mistakes)
    if (!mistake->make) image = mistake->of_image(image);
  return image;
}

/// Applies them, and returns displayed values.
R2::Image Shown(const R2::Image& image, const MistakeList& mistakes) {
  return Displayed(Finished(image, mistakes), R2::Display::straight);
}

/// Returns the mistakes that are applied before an image is rendered.
MistakeList BeforeRendering(const MistakeList& mistakes) {
  MistakeList made;
  std::ranges::copy_if(mistakes, std::back_inserter(made), [](const Mistake* mistake) { return mistake->make; });
  return made;
}

/// Returns the largest change of each pixel between its middle and its corners.
std::vector<double> SpreadOf(const R2::Image& image, const std::vector<R2::Image>& corners) {
  std::vector<double> spread;
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) {
      double& largest = spread.emplace_back(0);
      for (const R2::Image& moved : corners)
        largest = std::max(largest, LargestChannel(moved.At(x, y) - image.At(x, y)));
    }
  return spread;
}

/// Returns true if a blended normal points away from the viewer where the surface does not: some programs then flip it.
bool FacesAwayBySmoothing(const R3::Intersection& at, const R3::Vector& direction) {
  return Dot(at.normal, direction) * Dot(at.shading_normal, direction) < 0;
}

std::unique_ptr<const Accelerator> Accelerated(const World& world, const AcceleratorSettings& settings) {
  return FindAcceleratorKind(settings.name)->Make(world, settings);
}

R2::Image Rendered(const Variant& variant, const World& world, const Accelerator& exact) {
  const RenderSettings& settings = variant.settings;
  const RuledDepth ruled(world, variant.depth);
  const Accelerator& accelerator = variant.depth == DepthRules() ? exact : ruled;
  if (variant.rules == ShadingRules()) return Render(world, accelerator, settings).image;
  const TraceSettings trace = TraceSettingsOf(settings);
  if (settings.mode != RenderMode::whitted || !RuledShading::CanShade(world, trace)) return {};
  return Render(world, RuledShading(world, accelerator, trace, variant.rules), settings).image;
}

}  // namespace

/// The scene of the reference, ready for rays.
struct SceneImages::Built {
  explicit Built(SceneToRender loaded)
      : scene(std::move(loaded)), world(scene.scene), accelerator(Accelerated(world, scene.accelerator)) {}
  SceneToRender scene;
  World world;
  std::unique_ptr<const Accelerator> accelerator;
};

SceneImages::SceneImages(const SuiteScene& scene, const std::string& file, const Loader& load)
    : scene_(scene), file_(file), built_(std::make_unique<Built>(load(scene, file))) {
  reference_ = *With({});
  RefuseIdleOptions(load);
  FindSteadyPixels();
}

void SceneImages::RefuseIdleOptions(const Loader& load) {
  std::vector<std::vector<std::string>> options;  // each with its arguments
  for (const std::string& word : SplitWords(scene_.options)) {
    if (options.empty() || LooksLikeOption(word)) options.emplace_back();
    options.back().push_back(word);
  }
  for (std::size_t i = 0; i < options.size(); ++i) {
    SuiteScene without = scene_;
    without.options.clear();
    for (std::size_t k = 0; k < options.size(); ++k)
      if (k != i) without.options += ShellLine(options[k]) + " ";
    const SceneToRender scene = load(without, file_);
    const World world(scene.scene);
    const R2::Image image = Render(world, *Accelerated(world, scene.accelerator), scene.settings).image;
    if (image.Channels() != light_.at({}).Channels()) continue;
    SceneError at = scene_.options_at;
    if (at.file.empty()) at.file = scene_.file;
    at.message = "the option " + Quoted(ShellLine(options[i])) + " does not change the image of " + scene_.name;
    throw SceneErrors({at});
  }
}

SceneImages::~SceneImages() = default;

void SceneImages::FindSteadyPixels() {
  const int width = reference_.Width(), height = reference_.Height();
  steady_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), true);
  spread_.assign(steady_.size(), 0.0);
  if (scene_.runs > 1) return;  // blocks are compared, whose means an edge changes little
  corners_ = CornersWith({});
  spread_ = SpreadOf(reference_, corners_);
  for (std::size_t i = 0; i < spread_.size(); ++i) steady_[i] = spread_[i] <= scene_.tolerance;
  const auto& [scene, settings, accelerator] = built_->scene;
  const Camera& camera = settings.view ? *settings.view : scene.camera;
  Workspace workspace;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto ray = camera.RayThrough(x + 0.5, y + 0.5, width, height);
      const auto hit = ray ? built_->accelerator->Intersect(*ray, workspace) : std::nullopt;
      if (!hit || !(hit->is_contested || FacesAwayBySmoothing(built_->world.At(*ray, *hit), ray->direction))) continue;
      steady_[static_cast<std::size_t>(y * width + x)] = false;
    }
}

std::vector<double> SceneImages::SpreadWith(const MistakeList& mistakes) {
  const auto kept = spread_with_.find(mistakes);
  if (kept != spread_with_.end()) return kept->second;
  const auto image = With(mistakes);
  if (!image) return spread_;
  return spread_with_.emplace(mistakes, SpreadOf(*image, CornersWith(mistakes))).first->second;
}

std::vector<R2::Image> SceneImages::CornersWith(const MistakeList& mistakes) const {
  std::vector<R2::Image> corners;
  for (const R2::Vector& shift : shifts) corners.push_back(Shown(Light(BeforeRendering(mistakes), shift), mistakes));
  return corners;
}

R2::Image SceneImages::Light(const MistakeList& mistakes, R2::Vector shift_in_pixels) const {
  const SceneToRender& scene = built_->scene;
  Variant variant(scene.scene, scene.settings);
  for (const Mistake* mistake : mistakes) mistake->make(variant);
  Shift(variant, shift_in_pixels);
  if (!variant.HasOwnScene()) return Rendered(variant, built_->world, *built_->accelerator);
  const World world(variant.scene());
  return Rendered(variant, world, *Accelerated(world, scene.accelerator));
}

std::optional<R2::Image> SceneImages::With(const MistakeList& mistakes) {
  const auto light = LightWith(mistakes);
  if (!light) return {};
  return Displayed(*light, R2::Display::straight);
}

std::optional<R2::Image> SceneImages::LightWith(const MistakeList& mistakes) {
  const MistakeList before = BeforeRendering(mistakes);
  constexpr std::size_t most_kept = 500;  // 65 MB of images of 120 x 90
  auto kept = light_.find(before);
  if (kept == light_.end() && light_.size() >= most_kept && before.size() > 1) {
    const R2::Image light = Light(before);
    if (light.Width() == 0) return {};
    return Finished(light, mistakes);
  }
  if (kept == light_.end()) kept = light_.emplace(before, Light(before)).first;
  if (kept->second.Width() == 0) return {};
  return Finished(kept->second, mistakes);
}

R2::Image SceneImages::AsOfAnother(const MistakeList& mistakes) const {
  const R2::Image light = Light(BeforeRendering(mistakes), {0.11, -0.07});
  if (light.Width() == 0) return {};
  R2::Image image = Shown(light, mistakes);
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) {
      const R2::Color c = image.At(x, y);
      image.Set(x, y, {R2::ToByte(c.r) / 255.0, R2::ToByte(c.g) / 255.0, R2::ToByte(c.b) / 255.0});
    }
  return image;
}

R2::Image SceneImages::Cells(const R2::Image& image) const {
  const int side = CellSide();
  if (side == 1) return image;
  R2::Image cells((image.Width() + side - 1) / side, (image.Height() + side - 1) / side);
  for (int y = 0; y < cells.Height(); ++y)
    for (int x = 0; x < cells.Width(); ++x) {
      R2::Color sum;
      int count = 0;
      for (int j = side * y; j < std::min(side * (y + 1), image.Height()); ++j)
        for (int i = side * x; i < std::min(side * (x + 1), image.Width()); ++i) sum += image.At(i, j), ++count;
      cells.Set(x, y, sum / count);
    }
  return cells;
}

std::string SceneImages::RayTreeAt(int x, int y) const {
  constexpr std::size_t most_rays = 24;
  const PixelTracer tracer(built_->world, *built_->accelerator, built_->scene.settings);
  std::string tree = RayTree(tracer.Trace(x, y, 1), built_->world, built_->scene.settings, most_rays);
  // Students know the scene by its name, not by the folder where the grader stores it.
  const std::string folder = file_.substr(0, file_.rfind('/') + 1);
  for (std::size_t at = tree.find(folder); !folder.empty() && at != std::string::npos; at = tree.find(folder, at))
    tree.erase(at, folder.size());
  return tree;
}

}  // namespace ray::grade
