#include "source/app/rayview/StoppedRender.h"

#include <exception>
#include <string_view>
#include <utility>
#include <vector>

#include "source/app/files/SceneHash.h"

namespace ray {
namespace {

/// Returns the identity that raypro would give the render: that of the scene's files, which equal those on disk unless
/// they were edited.
std::string IdentityForRaypro(const RenderJob& job, RenderOptions options) {
  options.program = &Program::raypro;
  return IdentityOf(options, SceneHash(job.scene().parsed.scene.files));
}

bool IsEdited(const LoadedScene& scene) {
  std::vector<std::string_view> texts;
  for (const ScnPlaces::File& file : scene.places.files) texts.emplace_back(file.text->bytes);
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
