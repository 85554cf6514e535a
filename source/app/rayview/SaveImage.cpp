#include "source/app/rayview/SaveImage.h"

#include <cassert>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include "source/app/files/SceneHash.h"
#include "source/app/manual/Help.h"
#include "source/app/options/SceneSettings.h"
#include "source/scene/CameraText.h"

namespace ray {
namespace {

/// Returns the texts of the scene's files as read, including unsaved edits.
std::vector<std::string_view> TextsOf(const LoadedScene& scene) {
  std::vector<std::string_view> texts;
  for (const ScnPlaces::File& file : scene.places.files) texts.emplace_back(file.text->bytes);
  return texts;
}

RunStats StatsOf(const RenderOptions& options, const LoadedScene& scene, const RenderResult& result, double seconds) {
  RunStats stats;
  stats.options = options;
  stats.image_file = options.files.image;
  stats.scene.hash = SceneHash(scene.parsed.scene.files, TextsOf(scene));
  stats.scene.settings = SettingsInForce(scene.parsed.scene, options);
  stats.threads = ThreadsOf(options.render);
  stats.seconds.wall = seconds;
  stats.Take(result);
  return stats;
}

}  // namespace

std::string SaveTraced(const ImageOutput* output, RenderOptions options, const LoadedScene& scene,
                       const RenderResult& result, double seconds) {
  assert(result.IsComplete());
  std::optional<Camera>& view = options.render.view;
  if (view && CameraLine(*view) == CameraLine(scene.parsed.scene.camera)) view.reset();
  const ImageOutput place = output ? *output : ClaimImageName("jpg");
  options.files.image = place.file.name;
  const RunStats stats = StatsOf(options, scene, result, seconds);
  try {
    WriteImage({place.format, place.file, {}, {}, {}}, result, {}, stats);
  } catch (...) {
    std::error_code ignored;
    if (!output) std::filesystem::remove(place.file.target, ignored);  // claimed, and still empty
    throw;
  }
  return FinalLine(stats);
}

void SaveDrawing(const ImageOutput& output, const R2::Image& drawing, R2::ImageEncoding encoding) {
  encoding.srgb = false;
  WarnOfLink(Program::rayview, output.file);
  WriteWhole(output.file, output.format->encode(drawing, encoding, {{"program", NameAndVersion(Program::rayview)}}));
}

}  // namespace ray
