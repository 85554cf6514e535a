#include "source/view/commands/Images.h"

#include <algorithm>
#include <cmath>

#include "source/scene/CameraText.h"
#include "source/text/NumberText.h"
#include "source/view/live/JobStatus.h"

namespace ray {

void SetExposure(ViewerState& viewer, double steps) {
  viewer.exposure_steps = steps;
  viewer.notices.Redraw();
  viewer.notices.Tell("exposure " + Rounded(steps, 4) + (std::abs(steps) == 1 ? " stop" : " stops"));
}

void ChangeExposure(ViewerState& viewer, double steps) {
  SetExposure(viewer, steps == 0 ? 0 : viewer.exposure_steps + steps);
}

void KeepImage(ViewerState& viewer, const RenderJob& job) {
  const RenderResult& result = *job.Result();
  const bool has_claim = job.Settings().budget.IsOpen();
  std::string command = viewer.host.CommandFor(job.Settings());
  // The command says no camera, and a shell takes what is behind # for a comment.
  if (!command.empty() && job.Settings().view) command += "  # " + CameraLine(*job.Settings().view);
  viewer.images.Add({std::make_shared<const R2::Image>(result.image), viewer.settings.scene, std::move(command),
                     has_claim ? ClaimOf(result) : "", job.Seconds(), result.samples.mean});
}

std::optional<std::size_t> ShownImage(const ViewerState& viewer) {
  if (!viewer.shown_image || viewer.pictures.HowCompared() != TracedPictures::Comparing::reference) return {};
  const auto& all = viewer.images.All();
  const auto found = std::ranges::find(all, viewer.shown_image, &KeptImage::image);
  if (found == all.end()) return {};
  return static_cast<std::size_t>(found - all.begin());
}

void ShowImage(ViewerState& viewer, std::optional<std::size_t> index) {
  viewer.notices.Redraw();
  if (!index || *index >= viewer.images.All().size()) {
    viewer.shown_image.reset();
    viewer.pictures.Compare(TracedPictures::Comparing::no);
    return viewer.notices.Tell("the current image");
  }
  viewer.shown_image = viewer.images.All()[*index].image;
  viewer.pictures.SetReference({viewer.shown_image});
  viewer.pictures.Compare(TracedPictures::Comparing::reference);
  viewer.notices.Tell("image " + std::to_string(viewer.images.NumberOf(*index)) + ", now the reference");
}

void StopShowingReference(ViewerState& viewer) {
  if (viewer.pictures.HowCompared() == TracedPictures::Comparing::reference)
    Compare(viewer, TracedPictures::Comparing::no);
}

void CompareInFalseColors(ViewerState& viewer) {
  const bool has_them = viewer.pictures.HowCompared() == TracedPictures::Comparing::false_colors;
  Compare(viewer, has_them ? TracedPictures::Comparing::flip : TracedPictures::Comparing::false_colors);
}

void FlipImages(ViewerState& viewer, int by) {
  const auto count = static_cast<int>(viewer.images.All().size());
  if (count == 0) return viewer.notices.Tell("no image is finished yet; S renders one");
  // The current image is between the last and the first.
  const auto shown = ShownImage(viewer);
  const int now = shown ? static_cast<int>(*shown) : count;
  const int next = (now + by + count + 1) % (count + 1);
  ShowImage(viewer, next == count ? std::nullopt : std::optional(static_cast<std::size_t>(next)));
}

void KeepReference(ViewerState& viewer) {
  const auto current = viewer.pictures.Current();
  if (!current) return viewer.notices.Tell("nothing is rendered yet; press S or P first");
  viewer.pictures.SetReference({current});
  viewer.notices.Tell("image kept as the reference");
}

void Compare(ViewerState& viewer, TracedPictures::Comparing how) {
  viewer.pictures.Compare(viewer.pictures.HowCompared() == how ? TracedPictures::Comparing::no : how);
  viewer.notices.Tell(viewer.pictures.HowCompared() == TracedPictures::Comparing::no ? "comparing off"
                                                                                     : viewer.pictures.Comparison());
}

}  // namespace ray
