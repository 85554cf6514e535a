#include "source/view/ViewerState.h"

#include <algorithm>
#include <utility>

#include "source/scene/CameraText.h"

namespace ray {

Layout Layout::Of(const DrawingSize& all, double column, double bar, bool has_section) {
  const int width = std::max(1, all.width - static_cast<int>(column));
  const int height = std::max(1, all.height - static_cast<int>(bar));
  const int view = has_section ? std::max(1, width / 2) : width;
  return {{view, height}, {width - view, height}, all.height - height};
}

bool Layout::IsOnSection(const R2::Point& position) const {
  return position.x >= view.width && position.x < view.width + section.width && position.y >= 0 &&
         position.y < section.height;
}

PixelBox Layout::PlaceFor(double width, double height) const {
  const double scale = std::min(view.width / width, view.height / height);
  return {(view.width - scale * width) / 2, (view.height - scale * height) / 2, scale * width, scale * height};
}

ViewerState::ViewerState(ViewerSettings begin, const LoadedScene& shown, ViewerHost& around)
    : host(around),
      settings(std::move(begin)),
      navigator(shown.parsed.scene.camera, shown.parsed.scene.root.bounds,
                {settings.render.width, settings.render.height}),
      bookmarks(settings.scene),
      panels(MakePanels()),
      screen{{settings.render.width, settings.render.height}} {
  panels->SetLook(settings.panels);
  panels->SetParts(Parts());
  traced.SetReference(settings.reference);
}

Layout ViewerState::layout() const {
  return Layout::Of(screen.size, shows.panels ? panels->Width(screen.size.width) : 0,
                    shows.panels ? panels->HeightOfBar() : 0, section.IsShown());
}

RenderSettings ViewerState::SettingsFor(const DrawingSize& size) const {
  RenderSettings render = settings.render;
  render.width = size.width;
  render.height = size.height;
  const Camera &own = scene.Parsed().camera, &now = navigator.camera();
  // The scene's own view is left unsaid, so that the same command as without a viewer makes the same image.
  if (CameraLine(now) != CameraLine(own)) render.view = now;
  return render;
}

std::optional<R3::Ray> ViewerState::RayAt(const R2::Point& position) const {
  const DrawingSize view = layout().view;
  if (traced.ShownLive()) return navigator.camera().RayThrough(position.x, position.y, view.width, view.height);
  return navigator.camera().Through(position.x, position.y, view.width, view.height);
}

std::optional<R3::Point> ViewerState::PointAt(const R2::Point& position) const {
  const auto ray = RayAt(position);
  if (!ray) return {};
  Workspace workspace;
  const auto hit = scene.Loaded().accelerator->Intersect(*ray, workspace);
  if (!hit) return {};
  return scene.world().At(*ray, *hit).position;
}

const RenderJob* ViewerState::FlatJob() const { return flat.IsShown() ? traced.Job() : nullptr; }

RenderSettings ViewerState::SettingsOfShownImage() const {
  const RenderJob* job = FlatJob();
  return job ? job->Settings() : SettingsOfView();
}

Camera ViewerState::CameraOfShownImage() const {
  const RenderJob* job = FlatJob();
  return job ? job->Settings().view.value_or(scene.Parsed().camera) : navigator.camera();
}

DrawingSize ViewerState::SizeOfPreview() const {
  const RenderJob* job = FlatJob();
  return job ? DrawingSize{job->Settings().width, job->Settings().height} : layout().view;
}

PixelBox ViewerState::FittingPlace() const {
  // In the middle of the view: of its own view, where the scene is drawn as the image shows it.
  const RenderSettings image = SettingsOfShownImage();
  return layout().PlaceFor(image.width, image.height);
}

R2::Point ViewerState::InShownImage(const R2::Point& position) const {
  const PixelBox place = PlaceOfShownImage();
  const RenderSettings image = SettingsOfShownImage();
  return {(position.x - place.left) / place.width * image.width,
          (position.y - place.bottom) / place.height * image.height};
}

R2::Point ViewerState::InImage(const R2::Point& position) const {
  const PixelBox place = layout().PlaceFor(screen.size.width, screen.size.height);
  return {(position.x - place.left) / place.width * screen.size.width,
          (position.y - place.bottom) / place.height * screen.size.height};
}

PixelBox ViewerState::PlaceOf(const RenderJob& job) const {
  const PixelBox all = PlaceOfShownImage();
  const PixelRectangle region = RegionOf(job.Settings());
  const double across = all.width / job.Settings().width, up = all.height / job.Settings().height;
  return {all.left + region.x0 * across, all.bottom + region.y0 * up, region.Width() * across, region.Height() * up};
}

std::optional<TracedQuad> ViewerState::Quad() const {
  if (!overlays.quad || !traced.Trace() || traced.IsLive()) return {};
  return TracedQuad(traced.Trace()->Settings(), scene.Parsed().camera, navigator.Center(), scene.Space().radius);
}

}  // namespace ray
