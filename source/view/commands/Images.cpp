#include "source/view/commands/Commands.h"

#include <algorithm>
#include <cmath>

#include "R1/Elementary.h"
#include "source/scene/CameraText.h"
#include "source/text/NumberText.h"
#include "source/view/live/JobStatus.h"

namespace ray {

void SetExposure(ViewerState& viewer, double steps) {
  viewer.exposure_steps = steps;
  viewer.notices.Redraw();
  viewer.notices.Show("exposure " + Rounded(steps, 4) + (std::abs(steps) == 1 ? " stop" : " stops"));
}

void ChangeExposure(ViewerState& viewer, double steps) {
  SetExposure(viewer, steps == 0 ? 0 : viewer.exposure_steps + steps);
}

void KeepImage(ViewerState& viewer, const RenderJob& job) {
  const RenderResult& result = *job.Result();
  const bool has_claim = job.Settings().budget.IsOpen();
  std::string command = viewer.host.CommandFor(job.Settings());
  // The command has no option for a camera; to a shell, text after # is a comment.
  if (!command.empty() && job.Settings().view) command += "  # " + CameraLine(*job.Settings().view);
  viewer.images.Add({std::make_shared<const R2::Image>(result.image), viewer.settings.scene, std::move(command),
                     has_claim ? ClaimOf(result) : "", job.Seconds(), result.samples.mean});
}

std::optional<std::size_t> ShownImage(const ViewerState& viewer) {
  if (!viewer.shown_image || viewer.traced.HowCompared() != TracedImages::Comparing::reference) return {};
  const auto& all = viewer.images.All();
  const auto found = std::ranges::find(all, viewer.shown_image, &KeptImage::image);
  if (found == all.end()) return {};
  return static_cast<std::size_t>(found - all.begin());
}

void ShowImage(ViewerState& viewer, std::optional<std::size_t> index) {
  viewer.notices.Redraw();
  if (!index || *index >= viewer.images.All().size()) {
    viewer.shown_image.reset();
    viewer.traced.Compare(TracedImages::Comparing::no);
    return viewer.notices.Show("the current image");
  }
  viewer.shown_image = viewer.images.All()[*index].image;
  viewer.traced.SetReference({viewer.shown_image});
  viewer.traced.Compare(TracedImages::Comparing::reference);
  viewer.notices.Show("image " + std::to_string(viewer.images.NumberOf(*index)) + ", now the reference");
}

void StopShowingReference(ViewerState& viewer) {
  if (viewer.traced.HowCompared() == TracedImages::Comparing::reference) Compare(viewer, TracedImages::Comparing::no);
}

void CompareInFalseColors(ViewerState& viewer) {
  const bool has_them = viewer.traced.HowCompared() == TracedImages::Comparing::false_colors;
  Compare(viewer, has_them ? TracedImages::Comparing::flip : TracedImages::Comparing::false_colors);
}

void FlipImages(ViewerState& viewer, int by) {
  const auto count = static_cast<int>(viewer.images.All().size());
  if (count == 0) return viewer.notices.Show("no image is finished yet; S renders one");
  // The current image is between the last and the first.
  const auto shown = ShownImage(viewer);
  const int now = shown ? static_cast<int>(*shown) : count;
  const int next = (now + by + count + 1) % (count + 1);
  ShowImage(viewer, next == count ? std::nullopt : std::optional(static_cast<std::size_t>(next)));
}

void KeepReference(ViewerState& viewer) {
  const auto current = viewer.traced.Current();
  if (!current) return viewer.notices.Show("nothing is rendered yet; press S or P first");
  viewer.traced.SetReference({current});
  viewer.notices.Show("image kept as the reference");
}

void Compare(ViewerState& viewer, TracedImages::Comparing how) {
  viewer.traced.Compare(viewer.traced.HowCompared() == how ? TracedImages::Comparing::no : how);
  viewer.notices.Show(viewer.traced.HowCompared() == TracedImages::Comparing::no ? "comparing off"
                                                                                 : viewer.traced.Comparison());
}

namespace {

constexpr double zoom_of_a_step = 1.25;
constexpr double reach_of_slider = 5;       // pixels to each side in which it is taken hold of
constexpr double largest_preview = 16'384;  // pixels a side: OpenGL's least limit of a viewport, where it has one
constexpr double largest_image = 262'144;

}  // namespace

void ToggleFlat(ViewerState& viewer) {
  viewer.notices.RedrawLines();
  if (viewer.flat.IsShown()) {
    viewer.flat.Hide();
    return viewer.notices.Show("flat image off");
  }
  if (!viewer.traced.Trace() && !viewer.traced.IsLive())
    return viewer.notices.Show("nothing is rendered yet; press S or P first");
  viewer.flat.Show();
  viewer.notices.Show("flat image: wheel zooms, drag moves, Shift+drag slides against the " +
                      std::string(viewer.traced.Reference() ? "reference" : "preview"));
}

void DragFlat(ViewerState& viewer, const R2::Point& from, const R2::Point& to, bool moves_slider) {
  if (moves_slider) {
    if (!viewer.traced.Reference() && viewer.PlaceOfShownImage().width > largest_preview)
      return viewer.notices.Show("zoom out to slide against the preview");
    viewer.flat.SetSlider(to.x / viewer.layout().view.width);
    viewer.notices.Show("slider at " + Rounded(100 * viewer.flat.Slider(), 3) + " %");
  } else {
    viewer.flat.Pan(to - from);
  }
  viewer.notices.Redraw();
}

bool TakesSlider(const ViewerState& viewer, const ButtonEvent& event) {
  return event.modifiers.shift ||
         std::abs(event.x - viewer.flat.Slider() * viewer.layout().view.width) <= reach_of_slider;
}

void ZoomFlat(ViewerState& viewer, const ScrollEvent& event) {
  viewer.flat.Zoom(R1::Pow(zoom_of_a_step, event.steps), {event.x, event.y}, viewer.FittingPlace(),
                   viewer.traced.Reference() || viewer.flat.Slider() == 1 ? largest_image : largest_preview);
  viewer.notices.Show("zoom " + Fixed(100 * viewer.PlaceOfShownImage().width / viewer.SettingsOfShownImage().width, 0) +
                      " %");
}

}  // namespace ray
