#include "source/view/show/Show.h"

#include <cmath>
#include <utility>

#include "R1/Elementary.h"
#include "source/inspect/ImageLines.h"
#include "source/render/Layer.h"
#include "source/view/commands/Commands.h"

namespace ray {
namespace {

constexpr R2::Color dark_section_ground{0.04, 0.04, 0.05}, light_section_ground{0.96, 0.96, 0.97};

R2::Color InverseOf(const R2::Color& c) { return {1 - c.r, 1 - c.g, 1 - c.b}; }

bool IsLight(RenderMode mode) {
  return mode == RenderMode::whitted || mode == RenderMode::path || mode == RenderMode::albedo;
}

/// The rows of key S that are done.
void ShowTrace(const TracedImages& traced, FrameState::ShownImage& image) {
  image.frame = &traced.Trace()->frame();
  image.number = traced.TraceNumber();
  image.rows = traced.Trace()->RowsDone();
}

/// Returns the image of key S in space; std::nullopt if it is not there.
std::optional<FrameState::ShownImage> QuadInSpace(const ViewerState& viewer, const Exposure& exposure) {
  const auto quad = viewer.Quad();
  if (!quad) return {};
  FrameState::ShownImage image;
  ShowTrace(viewer.traced, image);
  image.exposure = exposure;
  image.corners.emplace();
  for (std::size_t i = 0; i < quad->Corners().size(); ++i)
    (*image.corners)[i] = viewer.scene.Space().At(quad->Corners()[i]);
  return image;
}

/// Returns the image that covers the view, live or flat; std::nullopt if none does.
std::optional<FrameState::ShownImage> CoveringImage(const ViewerState& viewer) {
  FrameState::ShownImage image;
  image.exposure = {R1::Exp2(viewer.exposure_steps), viewer.settings.render.srgb, viewer.settings.render.quantization};
  const bool is_traced = !viewer.traced.IsLive() && viewer.traced.Trace();
  image.place = is_traced ? viewer.PlaceOf(*viewer.traced.Trace()) : viewer.PlaceOfShownImage();
  if (auto compared = viewer.traced.Compared()) {
    image.image = std::move(compared);
    if (viewer.traced.ShowsEncodedDifference()) image.exposure.srgb = false;
    if (viewer.traced.ShowsFalseColors()) image.exposure = {};
    return image;
  }
  if (viewer.FlatJob() && !viewer.traced.IsLive()) {
    ShowTrace(viewer.traced, image);
    return image;
  }
  if (!viewer.traced.ShownLive() || !viewer.overlays.faces) return {};
  const RenderJob& job = *viewer.traced.ShownLive();
  image.opacity = viewer.traced.Opacity();
  const RenderMode mode = job.Settings().mode;
  if (IsLight(mode)) {
    image.frame = &job.frame();
    image.number = viewer.traced.ShownLiveNumber();
  } else {
    // Colors that stand for something else than light: as image files show them.
    image.image = std::make_shared<const R2::Image>(LayerAsShown(mode, job.frame().Image()));
    image.exposure = {1, false, viewer.settings.render.quantization};
  }
  return image;
}

/// Sets the parts of a frame that the flat image needs: the slider, the part right of it, and nothing in space.
void ShowFlat(const ViewerState& viewer, FrameState& shown) {
  if (!viewer.FlatJob() || !shown.covering) return;
  static const auto no_lines = std::make_shared<const Lines>();
  shown.lines = no_lines;
  shown.marks = shown.lit = nullptr;
  shown.shows_edges = false;
  shown.split = static_cast<int>(std::lround(viewer.flat.Slider() * shown.view.width));
  if (!viewer.traced.Reference()) return;
  shown.beside = FrameState::ShownImage{};
  shown.beside->image = viewer.traced.Reference();
  shown.beside->exposure = shown.covering->exposure;
  const RenderSettings& settings = viewer.FlatJob()->Settings();
  const bool is_whole =
      shown.beside->image->Width() == settings.width && shown.beside->image->Height() == settings.height;
  shown.beside->place = is_whole ? viewer.PlaceOfShownImage() : shown.covering->place;
}

/// Replaces lines in space, which are drawn as a pinhole sees them, by those of the projection of the live image.
/// Parts that are hidden there are fainter. The edges of triangles are not drawn.
///   depths   of that image; null for none, so that nothing is hidden
void ProjectLines(const ViewerState& viewer, FrameState& shown, const Frame* depths) {
  constexpr double rounding = 1.002;  // of the depth of a pixel's middle
  const DrawingSize view = shown.view;
  const auto is_visible = [&](const R3::Point& p, const R3::Ray& sight, const R2::Point& place) {
    const int x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y));
    if (!depths || x < 0 || y < 0 || x >= depths->Width() || y >= depths->Height()) return true;
    const double depth = depths->At(x, y).r;
    return depth == 0 || Length(p - sight.origin) <= rounding * depth;
  };
  const ImageLines image_lines(viewer.navigator.camera(), view.width, view.height, is_visible);
  const DrawingSpace& space = viewer.scene.Space();
  const auto at = [&](const R2::Point& p) {
    return std::array{static_cast<float>(2 * p.x / view.width - 1), static_cast<float>(2 * p.y / view.height - 1), 0.F};
  };
  for (auto* lines : {&shown.lines, &shown.marks, &shown.lit}) {
    if (!*lines) continue;
    Lines flat;
    for (std::size_t i = 0; i + 1 < (*lines)->size(); i += 2) {
      const Vertex &from = (**lines)[i], &to = (**lines)[i + 1];
      for (const ImageLine& line : image_lines.Of(space.PointAt(from.at), space.PointAt(to.at))) {
        Rgba color = from.color;
        if (line.is_hidden) color[3] = static_cast<std::uint8_t>(hidden_lines * color[3]);
        AddLine(flat, at(line.from), at(line.to), color);
      }
    }
    *lines = std::make_shared<const Lines>(std::move(flat));
  }
  shown.has_flat_lines = true;
  shown.shows_edges = false;
}

/// Returns true if lines in space are drawn over the view.
bool HasLines(const FrameState& shown) {
  return !shown.lines->empty() || (shown.marks && !shown.marks->empty()) || shown.lit || shown.shows_edges;
}

}  // namespace

FrameState MakeFrame(ViewerState& viewer, std::shared_ptr<const Lines> lines) {
  FrameState shown;
  shown.size = viewer.screen.size;
  shown.view = viewer.layout().view;
  shown.bottom = viewer.layout().bottom;
  if (viewer.section.IsShown()) {
    MakeSection(viewer);
    shown.section_size = viewer.section_pane.size;
    shown.section_ground = viewer.section_pane.theme == PanelTheme::light ? light_section_ground : dark_section_ground;
    shown.section = {viewer.section_pane.drawing, &viewer.section_pane.drawing->lines};
  }
  const Exposure exposure{R1::Exp2(viewer.exposure_steps), viewer.settings.render.srgb,
                          viewer.settings.render.quantization};
  const R2::Color background = exposure.factor * viewer.scene.Parsed().background;
  shown.background = exposure.srgb ? EncodeSrgb(background) : background;
  shown.seen_from = ViewFrom(viewer.CameraOfShownImage(), viewer.scene.Space(), viewer.SizeOfPreview(), exposure);
  shown.clip_from_drawing =
      ClipFromDrawing(viewer.CameraOfShownImage(), viewer.scene.Space(), BoxOfDrawing(viewer), viewer.SizeOfPreview());
  shown.faces = viewer.scene.Faces();
  shown.shows_faces = viewer.overlays.faces;
  shown.shows_edges = viewer.overlays.edges;
  shown.shows_shadows = viewer.overlays.shadows && viewer.settings.render.trace.shadows;
  shown.edge_color = Shown(InverseOf(shown.background));
  shown.lines = std::move(lines);
  shown.marks = std::make_shared<const Lines>(MakeMarks(viewer));
  if (viewer.crop) shown.crop = std::make_shared<const Lines>(FrameOfCrop(viewer));
  if (viewer.rays.Look().chosen)
    shown.lit =
        std::make_shared<const Lines>(ChosenRay(*viewer.rays.Pixel(), viewer.scene.Space(), viewer.rays.Look()));
  shown.quad = QuadInSpace(viewer, exposure);
  shown.covering = CoveringImage(viewer);
  if (shown.covering && viewer.traced.ShownLive() && HasLines(shown)) {
    viewer.traced.TraceDepths();
    const RenderJob* depths = viewer.traced.Depths();
    if (!viewer.navigator.camera().IsPinhole())
      ProjectLines(viewer, shown, depths ? &depths->frame() : nullptr);
    else if (depths)
      shown.covering->depths = {&depths->frame(), viewer.traced.DepthsNumber(), viewer.scene.Space().radius};
  }
  ShowFlat(viewer, shown);
  shown.line_width = LineWidth(viewer);
  shown.labels = MakeLabels(viewer);
  for (Label& label : shown.labels) label.y += shown.bottom;
  const PanelParts parts = viewer.Parts();
  if (!shown.labels.empty() || parts.column || parts.help || parts.bar)
    shown.panels = viewer.panels->Draw(viewer, shown.labels);
  return shown;
}

}  // namespace ray
