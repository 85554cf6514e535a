#include "source/draw/gl/Drawer.h"

#include <cmath>

namespace ray {
namespace {

constexpr double lit_width = 3;  // in pixels
constexpr int slider_width = 2;  // in pixels
constexpr R2::Color slider_color{1, 1, 1};
constexpr ClipMatrix as_it_is{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

ImageLook LookOf(const FrameState::ShownImage& shown) {
  return {.exposure = shown.exposure.factor,
          .srgb = shown.exposure.srgb,
          .truncated = shown.exposure.quantization == R2::Quantization::truncated,
          .rows = shown.rows,
          .alpha = shown.opacity};
}

int Whole(double pixels) { return static_cast<int>(std::lround(pixels)); }

/// Maps pixels of a view to the square from -1 to 1.
std::array<std::array<float, 3>, 4> CornersOf(const PixelBox& box, const DrawingSize& view) {
  const auto x = [&](double at) { return static_cast<float>(2 * at / view.width - 1); };
  const auto y = [&](double at) { return static_cast<float>(2 * at / view.height - 1); };
  const float left = x(box.left), right = x(box.left + box.width);
  const float low = y(box.bottom), high = y(box.bottom + box.height);
  return {{{left, low, 0}, {right, low, 0}, {right, high, 0}, {left, high, 0}}};
}

}  // namespace

template <typename List, typename GpuList, typename Uploader>
GpuList& Drawer::Upload(Slot<List, GpuList>& slot, const std::shared_ptr<const List>& list, const Uploader& uploader) {
  if (slot.list != list) {
    slot.uploaded.reset();  // first, so that both never exist at once
    slot.uploaded = uploader.Upload(*list);
    slot.list = list;
  }
  return *slot.uploaded;
}

void Drawer::Fit(ImageSlot& slot, int width, int height) {
  if (slot.uploaded && slot.uploaded->width == width && slot.uploaded->height == height) return;
  slot.uploaded.reset();
  slot.uploaded = painter_.images.Make(width, height);
}

const GpuImage& Drawer::Upload(ImageSlot& slot, const FrameState::ShownImage& shown) {
  if (shown.image)
    UploadImage(slot, shown.image);
  else
    UploadFrame(slot, *shown.frame, shown.number, shown.rows < 0 ? shown.frame->Height() : shown.rows);
  return *slot.uploaded;
}

void Drawer::UploadFrame(ImageSlot& slot, const Frame& frame, std::uint64_t number, int rows) {
  if (slot.number != number || slot.image) {
    slot.uploaded.reset();  // a new one is black
    Fit(slot, frame.Width(), frame.Height());
    slot.versions.assign(static_cast<std::size_t>(frame.Height()), 0);
    slot.image.reset();
    slot.number = number;
  }
  UploadNewRows(slot, frame, rows);
}

void Drawer::UploadImage(ImageSlot& slot, const std::shared_ptr<const R2::Image>& image) {
  if (slot.image == image) return;
  Fit(slot, image->Width(), image->Height());
  painter_.images.Update(*slot.uploaded, 0, image->Height(), image->Channels());
  slot.image = image;
  slot.number = 0;
}

/// Uploads runs of the rows below `end` that were written since the last call.
void Drawer::UploadNewRows(ImageSlot& slot, const Frame& frame, int end) {
  for (int row = 0; row < end; ++row) {
    const int first = row;
    while (row < end && frame.Version(row) != slot.versions[static_cast<std::size_t>(row)]) {
      slot.versions[static_cast<std::size_t>(row)] = frame.Version(row);
      ++row;
    }
    if (row == first) continue;
    rows_.clear();
    frame.Copy(first, row - first, rows_);
    painter_.images.Update(*slot.uploaded, first, row - first, rows_);
  }
}

void Drawer::DrawScene(const FrameState& state) {
  if (!state.faces) return;
  const SurfaceDrawer& surfaces = painter_.surfaces;
  GpuSurfaces& faces = Upload(faces_, state.faces, surfaces);
  const auto draw = [&] {
    surfaces.DrawSky(faces, state.seen_from);
    if (state.shows_faces) surfaces.Draw(faces, state.clip_from_drawing, state.seen_from, state.shows_shadows);
  };
  const auto draw_all = [&] {
    painter_.canvas.Fill(state.background);
    draw();
  };
  if (state.detail.pixel_step > 1) return painter_.coarse.Draw(state.detail.pixel_step, draw_all);
  if (state.detail.is_smooth) return painter_.coarse.DrawSmoothly(draw_all);
  draw();
}

void Drawer::DrawImage(const FrameState& state) {
  const auto draw = [&](ImageSlot& slot, const FrameState::ShownImage& shown) {
    painter_.images.DrawFlat(Upload(slot, shown), CornersOf(shown.place, state.view), LookOf(shown));
  };
  if (state.covering->opacity < 1) DrawScene(state);
  draw(covering_, *state.covering);
  if (const auto& depths = state.covering->depths; depths.frame) {
    UploadFrame(depths_, *depths.frame, depths.number, depths.frame->Height());
    painter_.images.DrawDepths(*depths_.uploaded, state.seen_from, state.clip_from_drawing, depths.unit);
  }
  const int width = state.view.width, height = state.view.height;
  if (state.split < 0 || state.split >= width) return;
  // The rest is drawn over it.
  Canvas& canvas = painter_.canvas;
  canvas.Clip(state.split, state.bottom, width - state.split, height);
  canvas.Fill(state.background);
  if (state.beside) {
    draw(beside_, *state.beside);
  } else {
    const PixelBox& place = state.covering->place;
    canvas.SetViewport(Whole(place.left), state.bottom + Whole(place.bottom), Whole(place.width), Whole(place.height));
    canvas.Clip(state.split, state.bottom, width - state.split, height);
    DrawScene(state);
    canvas.SetViewport(0, state.bottom, width, height);
  }
  canvas.Clip(state.split, state.bottom, slider_width, height);
  canvas.Fill(slider_color);
  canvas.SetViewport(0, state.bottom, width, height);
}

void Drawer::Draw(const FrameState& state) {
  Canvas& canvas = painter_.canvas;
  const ListDrawer& lists = painter_.lists;
  canvas.Begin(state.size.width, state.size.height, state.background);
  canvas.SetViewport(0, state.bottom, state.view.width, state.view.height);
  const ClipMatrix& clip = state.clip_from_drawing;
  const bool is_covered = state.covering.has_value();
  if (is_covered)
    DrawImage(state);
  else
    DrawScene(state);
  if (state.shows_edges && state.faces)
    painter_.surfaces.DrawEdges(Upload(faces_, state.faces, painter_.surfaces), clip, state.edge_color);
  if (state.quad && !is_covered)
    painter_.images.Draw(Upload(quad_, *state.quad), *state.quad->corners, clip, LookOf(*state.quad));
  const int width = state.line_width;
  const ClipMatrix& of_lines = state.has_flat_lines ? as_it_is : clip;
  const double hidden = state.has_flat_lines ? 1 : hidden_lines;
  lists.Draw(Upload(lines_, state.lines), of_lines, width, hidden);
  if (state.marks) lists.Draw(Upload(marks_, state.marks), of_lines, width, hidden);
  if (state.lit) lists.Draw(Upload(lit_, state.lit), of_lines, lit_width * width, hidden);
  if (state.crop) lists.Draw(Upload(crop_, state.crop), clip, width, 1);
  if (state.section) {
    canvas.SetViewport(state.view.width, state.bottom, state.section_size.width, state.section_size.height);
    canvas.Fill(state.section_ground);
    lists.Draw(Upload(section_, state.section), as_it_is, width, 1);
  }
  if (state.panels) painter_.panels.Draw(*state.panels, canvas);
}

}  // namespace ray
