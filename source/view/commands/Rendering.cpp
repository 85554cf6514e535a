#include "source/view/commands/Commands.h"

#include <algorithm>
#include <cmath>

#include "source/scene/CameraText.h"
#include "source/text/EnumNames.h"
#include "source/view/live/JobStatus.h"

namespace ray {
namespace {

/// Describes what happens to a render that was stopped.
std::string HowItContinues(ViewerState& viewer, const RenderJob& job) {
  if (!job.Canceled()) return "; nothing was saved";
  const std::string kept = viewer.host.KeepStopped(job);
  return "; S continues it while view and options are the same" + (kept.empty() ? "" : "; " + kept);
}

void SaveEnded(ViewerState& viewer, const RenderJob& job) {
  if (!job.Failure().empty()) return viewer.notices.Show("rendering failed: " + job.Failure());
  if (!job.IsComplete()) return viewer.notices.Show("rendering stopped" + HowItContinues(viewer, job));
  KeepImage(viewer, job);
  viewer.notices.Show(viewer.host.SaveTraced(job) +
                      (viewer.editor.HasUnsaved() ? "; the scene's changes are not saved yet" : ""));
}

void ShowEndedLive(ViewerState& viewer, const RenderJob& job) {
  if (!job.Failure().empty()) return viewer.notices.Show("rendering failed: " + job.Failure());
  if (job.IsComplete()) KeepImage(viewer, job);
  if (job.IsComplete() && job.Settings().budget.IsOpen()) viewer.notices.Show(ClaimOf(*job.Result()));
}

}  // namespace

void StartTrace(ViewerState& viewer) {
  const ViewerState::TracedAs as{viewer.scene.Number(), viewer.option_changes.number,
                                 CameraLine(viewer.navigator.camera()), viewer.screen.size, viewer.crop};
  const bool continues = viewer.traced.CanContinue() && as == viewer.traced_as;
  viewer.traced_as = as;
  RenderSettings settings = viewer.SettingsOfImage();
  settings.crop = viewer.crop;
  viewer.traced.StartTrace(viewer.scene.Shared(), settings, continues);
  viewer.traced.Suspend();
  viewer.overlays.quad = true;
  viewer.notices.Show(continues ? "rendering continues where it was stopped" : "rendering");
  viewer.notices.RedrawLines();
}

void Crop(ViewerState& viewer, const R2::Point& from, const R2::Point& to) {
  const R2::Point a = viewer.InImage(from), b = viewer.InImage(to);
  const auto pixel = [](double x, int size) { return std::clamp(static_cast<int>(std::floor(x)), 0, size - 1); };
  const int x0 = pixel(std::min(a.x, b.x), viewer.screen.size.width),
            x1 = pixel(std::max(a.x, b.x), viewer.screen.size.width) + 1;
  const int y0 = pixel(std::min(a.y, b.y), viewer.screen.size.height),
            y1 = pixel(std::max(a.y, b.y), viewer.screen.size.height) + 1;
  viewer.crop = PixelRectangle{x0, y0, x1, y1};
  viewer.notices.Show("crop of " + std::to_string(x1 - x0) + "x" + std::to_string(y1 - y0) +
                      " pixels; S renders it, Escape clears it");
}

void ClearCrop(ViewerState& viewer) {
  viewer.crop.reset();
  viewer.notices.Show("crop cleared; S renders the whole view");
}

void ShowTraced(ViewerState& viewer, std::optional<RenderMode> mode) {
  viewer.traced.ShowLive(mode);
  viewer.traced.Update(viewer.scene.Shared(), viewer.SettingsOfView(), viewer.settings.budget_of_rest);
  viewer.notices.RedrawLines();
  viewer.notices.Show(std::string("traced, mode ") + NameOf(mode.value_or(viewer.settings.render.mode)));
}

void ShowPreview(ViewerState& viewer) {
  viewer.traced.HideLive();
  viewer.notices.RedrawLines();
  viewer.notices.Show("preview");
}

void ToggleTraced(ViewerState& viewer) { viewer.traced.IsLive() ? ShowPreview(viewer) : ShowTraced(viewer, {}); }

void ToggleMode(ViewerState& viewer, RenderMode mode) {
  if (!viewer.traced.IsLive() || viewer.traced.LiveMode() != mode) return ShowTraced(viewer, mode);
  viewer.settings.shows_traced ? ShowTraced(viewer, {}) : ShowPreview(viewer);
}

void PauseOrResume(ViewerState& viewer) {
  if (!viewer.traced.IsLive()) return ShowTraced(viewer, {});
  if (viewer.traced.IsPaused()) {
    viewer.traced.ResumeLive();
    return viewer.notices.Show("tracing continues");
  }
  viewer.notices.Show(viewer.traced.StopLive() ? "tracing is paused; P continues it"
                                               : "the image has all its samples; Shift+P shows the preview");
}

void ToggleDenoising(ViewerState& viewer) {
  const bool is_on = viewer.settings.render.denoise;
  ChangeOption(viewer, "denoise", is_on ? "" : "on");
  if (viewer.settings.render.denoise == is_on) return;  // a message says why
  viewer.notices.Show(is_on ? "denoising off" : "denoising on: an image is filtered once it has all its samples");
}

void TakeEndedJobs(ViewerState& viewer) {
  if (const RenderJob* job = viewer.traced.TakeEnded()) SaveEnded(viewer, *job);
  if (const RenderJob* job = viewer.traced.TakeEndedLive()) ShowEndedLive(viewer, *job);
}

void CompareAccelerators(ViewerState& viewer) {
  viewer.accelerators.Begin(viewer.scene.Shared(), viewer.settings.accelerator, viewer.SettingsOfView());
  viewer.notices.Show("comparing accelerators");
}

void StopComparingAccelerators(ViewerState& viewer) {
  viewer.accelerators.Stop();
  viewer.notices.Show("comparing stops after the accelerator that is being built");
}

}  // namespace ray
