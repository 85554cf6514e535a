#include "source/app/rayview/SaveImage.h"

#include <cassert>
#include <exception>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "source/app/files/SceneHash.h"
#include "source/app/manual/Manual.h"
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

namespace {

/// Returns the identity that raypro would give the render: that of the scene's files, which equal those on disk unless
/// they were edited.
std::string IdentityForRaypro(const RenderJob& job, RenderOptions options) {
  options.program = &Program::raypro;
  return IdentityOf(options, SceneHash(job.scene().parsed.scene.files));
}

bool IsEdited(const LoadedScene& scene) {
  const std::vector<std::string_view> texts = TextsOf(scene);
  const std::vector<std::string>& files = scene.parsed.scene.files;
  return !texts.empty() && SceneHash(files, texts) != SceneHash(files);
}

}  // namespace

std::string StoppedRender::Keep(const RenderJob& stopped, RenderOptions options) {
  if (options.files.image.empty()) return {};
  if (stopped.Settings().view) return "raypro could not: the camera is not the scene's (Shift+K, Control+S)";
  if (IsEdited(stopped.scene())) return "raypro could not: the scene has changes that are not saved";
  try {
    const auto files = options.files;
    const std::string identity = IdentityForRaypro(stopped, std::move(options));
    if (identity != identity_) checkpoint_.reset();
    if (!checkpoint_) checkpoint_.emplace(files, CheckpointOptions{}, false);
    checkpoint_->Save(stopped.Canceled()->state, identity);
    identity_ = identity;
    return "raypro -resume also continues, from " + checkpoint_->Name();
  } catch (const std::exception& problem) {  // an existing file belongs to someone else
    return std::string("raypro could not: ") + problem.what();
  }
}

void StoppedRender::Finished(const RenderJob& complete, RenderOptions options) {
  if (checkpoint_ && IdentityForRaypro(complete, std::move(options)) == identity_) checkpoint_->ImageIsFinished(false);
  checkpoint_.reset();
  identity_.clear();
}

}  // namespace ray
