#include <algorithm>
#include <cmath>
#include <utility>

#include "source/scene/CameraText.h"
#include "source/text/NumberText.h"
#include "source/view/Viewer.h"
#include "source/view/edit/SceneFiles.h"
#include "source/view/live/JobStatus.h"

/// Scenes that are changed, other ones, and the images made of them.
namespace ray {

std::string Viewer::ShowEdits(std::shared_ptr<const EditedFiles> texts) {
  const bool was_in_place = !HasMovedCamera();
  ViewerSettings as_edited = settings_;
  as_edited.parse.edited = std::move(texts);
  try {
    auto scene = std::make_shared<const LoadedScene>(settings_.scene, as_edited.parse, as_edited.accelerator);
    TakeSettings(scene->parsed.scene);
    settings_.parse.edited = as_edited.parse.edited;
    TakeScene(std::move(scene));
  } catch (const SceneErrors& errors) {
    return errors.All().empty() ? errors.what() : errors.All().front().message;
  } catch (const std::exception& error) {
    return error.what();
  }
  // Whoever looks through the scene's camera goes with it.
  if (was_in_place && HasMovedCamera()) navigator_.Go(scene_->parsed.scene.camera);
  return {};
}

std::string Viewer::SaveScene(const std::string& file, const std::string& text) {
  std::string problem = host_.SaveScene(file, text);
  watch_.Watch(scene_->parsed.scene.files);  // it is known already
  return problem;
}

void Viewer::OpenNeighbor(int by) {
  const std::string file = NeighborOf(settings_.scene, ScenesBeside(settings_.scene), by);
  if (file.empty()) return ShowMessage("there is no other scene in the folder");
  OpenScene(file);
}

void Viewer::ToggleSceneList() {
  lists_scenes_ = !lists_scenes_;
  if (lists_scenes_ && !shows_panels_) ShowPanels(PanelLook());
  if (shows_panels_) ShowMessage(lists_scenes_ ? "scenes to open are in the panels" : "the list of scenes is closed");
}

void Viewer::ReadFromDisk() {
  if (!editor_.MayLose(*this, "reload the scene")) return;
  auto edited = std::exchange(settings_.parse.edited, nullptr);
  const int number = scene_number_;
  Reload();
  if (scene_number_ == number)
    settings_.parse.edited = std::move(edited);  // what is shown is still what was edited
  else
    editor_.Forget();
}

void Viewer::TellOfChangedFiles() {
  if (!editor_.HasUnsaved()) return ReadFromDisk();
  ShowMessage("the scene has changed on the disk; your changes stay, Control+Shift+S saves them as a copy");
}

R3::Ray Viewer::RayAt(const R2::Point& position) const {
  return navigator_.camera().Through(position.x, position.y, ViewSize().width, ViewSize().height);
}

void Viewer::SetExposure(double steps) {
  exposure_steps_ = steps;
  needs_redraw_ = true;
  ShowMessage("exposure " + Rounded(steps, 4) + (std::abs(steps) == 1 ? " stop" : " stops"));
}

void Viewer::KeepImage(const RenderJob& job) {
  const RenderResult& result = *job.Result();
  const bool has_claim = job.Settings().budget.IsOpen();
  std::string command = host_.CommandFor(job.Settings());
  // The command says no camera, and a shell takes what is behind # for a comment.
  if (!command.empty() && job.Settings().view) command += "  # " + CameraLine(*job.Settings().view);
  images_.Add({std::make_shared<const R2::Image>(result.image), settings_.scene, std::move(command),
               has_claim ? ClaimOf(result) : "", job.Seconds(), result.samples.mean});
}

std::optional<std::size_t> Viewer::ShownImage() const {
  if (!shown_image_ || pictures_.HowCompared() != TracedPictures::Comparing::reference) return {};
  const auto& all = images_.All();
  const auto found = std::ranges::find(all, shown_image_, &KeptImage::image);
  if (found == all.end()) return {};
  return static_cast<std::size_t>(found - all.begin());
}

void Viewer::ShowImage(std::optional<std::size_t> index) {
  needs_redraw_ = true;
  if (!index || *index >= images_.All().size()) {
    shown_image_.reset();
    pictures_.Compare(TracedPictures::Comparing::no);
    return ShowMessage("the current image");
  }
  shown_image_ = images_.All()[*index].image;
  pictures_.SetReference({shown_image_});
  pictures_.Compare(TracedPictures::Comparing::reference);
  ShowMessage("image " + std::to_string(images_.NumberOf(*index)) + ", now the reference");
}

void Viewer::FlipImages(int by) {
  const auto count = static_cast<int>(images_.All().size());
  if (count == 0) return ShowMessage("no image is finished yet; S renders one");
  // The current image is between the last and the first.
  const auto shown = ShownImage();
  const int now = shown ? static_cast<int>(*shown) : count;
  const int next = (now + by + count + 1) % (count + 1);
  ShowImage(next == count ? std::nullopt : std::optional(static_cast<std::size_t>(next)));
}

void Viewer::ToggleDenoising() {
  const bool is_on = settings_.render.denoise;
  ChangeOption("denoise", is_on ? "" : "on");
  if (settings_.render.denoise == is_on) return;  // a message says why
  ShowMessage(is_on ? "denoising off" : "denoising on: an image is filtered once it has all its samples");
}

void Viewer::FocusUnderPointer() { editor_.FocusOn(*this, PointAt(pointer_)); }

}  // namespace ray
