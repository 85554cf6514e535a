#include "source/view/overlay/SectionView.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "R1/Elementary.h"
#include "source/text/NumberText.h"
#include "source/view/overlay/CutDrawing.h"

namespace ray {
namespace {

constexpr int cut_lines = 512;     // of the grid that searches, each way
constexpr int rays_of_a_row = 20;  // so many pixels of it are traced, evenly spread
constexpr double step = 0.02;      // of the axis planes, in radii of the scene
constexpr double crossing_normal_length = 0.03;
constexpr Rgba crossing_normal_color{255, 120, 220, 160};
constexpr int normal_every = 16;  // crossings
constexpr Rgba camera_color{255, 230, 120, 255}, screen_color{120, 255, 160, 255};
constexpr double dot_radius = 4;          // pixels at letter size 1
constexpr double way_to_screen = 0.25;    // of the scene's radius, where no lens has a focus distance
constexpr double room_behind_eye = 0.1;   // of its way from the middle of the scene
constexpr double farthest_shown_eye = 5;  // radii from the middle of the scene; beyond, too little would be left of it

R3::Vector NormalOf(SlicePlane plane) {
  switch (plane) {
    case SlicePlane::xz:
      return {0, 1, 0};
    case SlicePlane::yz:
      return {1, 0, 0};
    case SlicePlane::xy:
      return {0, 0, 1};
    case SlicePlane::camera_row:
      break;
  }
  return {};
}

std::string NameOfPlane(SlicePlane plane) {
  return plane == SlicePlane::xz ? "xz" : plane == SlicePlane::yz ? "yz" : "xy";
}

}  // namespace

void SectionView::NextPlane() {
  constexpr std::array order{SlicePlane::camera_row, SlicePlane::xz, SlicePlane::yz, SlicePlane::xy};
  const auto now = std::ranges::find(order, plane_);
  plane_ = now + 1 == order.end() ? order.front() : now[1];
}

void SectionView::Move(int by, int height) {
  if (plane_ == SlicePlane::camera_row)
    row_ = std::clamp(Row(height) + by, 0, height - 1);
  else
    offset_ += step * by;
}

void SectionView::Cut(const LoadedScene& scene, const RenderSettings& settings, const R3::Point& center,
                      const DrawingSize& size) {
  rays_.clear();
  mark_.reset();
  R3::Box box = scene.parsed.scene.root.bounds;
  Slice slice;
  if (plane_ == SlicePlane::camera_row) {
    constexpr double middle = 0.5;  // of the row
    const Camera camera = settings.view.value_or(scene.parsed.scene.camera);
    slice = CameraSlice(camera, Row(settings.height) + middle, settings.width, settings.height, box);
    const PixelTracer tracer(scene.world, *scene.accelerator, settings);
    const int spacing = std::max(1, settings.width / rays_of_a_row);
    for (int column = 0; column < settings.width; column += spacing)
      rays_.push_back(tracer.Trace(column, Row(settings.height), 1));
    coordinates_ = {{"right", "ahead"}, slice.Project(camera.eye), "the eye"};
    const double radius = box.Radius() > 0 ? box.Radius() : 1;
    mark_ = MarkOf(camera, Row(settings.height) + middle, settings, slice, radius);
    // A little behind it too, so that the numbers along the edge are not over the dot.
    const R3::Vector way = camera.eye - box.Center();
    if (!box.IsEmpty() && Length(way) < farthest_shown_eye * radius) box.Extend(camera.eye + room_behind_eye * way);
  } else {
    const double radius = box.Radius() > 0 ? box.Radius() : 1;
    slice = AxisSlice(plane_, center + offset_ * radius * NormalOf(plane_), box);
    const std::string names = NameOfPlane(plane_);
    coordinates_ = {{names.substr(0, 1), names.substr(1)}, slice.Project(R3::Point{}), "the origin"};
  }
  view_ = SliceView::Of(slice, box, size);
  cut_ = CutOf(scene.world, *scene.accelerator, slice, cut_lines);
}

SliceAxes SectionView::Drawing(const LoadedScene& scene, const RayLook& look, int letter_size) const {
  SliceAxes drawing = AxesOf(view_, coordinates_, letter_size);
  Lines& lines = drawing.lines;
  Append(lines, CutFilling(*cut_, scene.world, view_));
  Append(lines, CutLines(*cut_, scene.world, view_));
  const Slice& slice = cut_->slice;
  for (std::size_t i = 0; i < cut_->crossings.size(); i += normal_every) {
    const Crossing& crossing = cut_->crossings[i];
    const R2::Point tip = crossing.on_slice + crossing_normal_length * slice.extent * crossing.normal;
    AddLine(lines, view_.At(crossing.on_slice), view_.At(tip), crossing_normal_color);
  }
  // Rays are drawn in a space of their own and dropped onto the plane from there.
  const Lines in_space = RayLines(rays_, DrawingSpace{slice.center, slice.extent}, look);
  for (const Vertex& v : in_space) {
    const R3::Vector way{slice.extent * static_cast<double>(v.at[0]), slice.extent * static_cast<double>(v.at[1]),
                         slice.extent * static_cast<double>(v.at[2])};
    lines.push_back({view_.At(slice.Project(slice.center + way)), v.color});
  }
  if (mark_) AddMark(lines, letter_size);
  return drawing;
}

SectionView::CameraMark SectionView::MarkOf(const Camera& camera, double y, const RenderSettings& settings,
                                            const Slice& slice, double scene_radius) {
  const double way = settings.camera.HasLens() ? settings.camera.focus : way_to_screen * scene_radius;
  const auto on_screen = [&](double x) {
    // Directions are 1 long along the axis.
    return slice.Project(camera.eye + way * camera.Through(x, y, settings.width, settings.height).direction);
  };
  return {slice.Project(camera.eye), on_screen(0), on_screen(settings.width)};
}

/// A dot, of a line for each row of pixels, and the line of the screen.
void SectionView::AddMark(Lines& lines, int letter_size) const {
  AddLine(lines, view_.At(mark_->left), view_.At(mark_->right), screen_color);
  const R2::Point eye = view_.Pixel(mark_->eye);
  const double radius = letter_size * dot_radius;
  const auto at = [&](double x, double y) { return view_.At(view_.InSlice({x, y})); };
  for (double y = -radius + 0.5; y < radius; ++y) {
    const double half = std::sqrt(radius * radius - y * y);
    AddLine(lines, at(eye.x - half, eye.y + y), at(eye.x + half, eye.y + y), camera_color);
  }
}

std::string SectionView::Tell(const R2::Point& pixel, const std::optional<R2::Point>& from) const {
  const auto length = [](const R2::Vector& v) { return Rounded(R1::Hypot(v.x, v.y), 4); };
  const R2::Point at = view_.InSlice(pixel);
  const R2::Vector way = at - coordinates_.origin;
  return coordinates_.names[0] + " " + Rounded(way.x, 4) + ", " + coordinates_.names[1] + " " + Rounded(way.y, 4) +
         ": " + length(way) + " from " + coordinates_.origin_name +
         (from ? ", " + length(at - view_.InSlice(*from)) + " from where the button went down" : "");
}

std::string SectionView::Describe(int height) const {
  switch (plane_) {
    case SlicePlane::camera_row:
      return "row " + std::to_string(Row(height));
    case SlicePlane::xz:
      return "xz at y " + Rounded(cut_ ? cut_->slice.center.y : 0, 4);
    case SlicePlane::yz:
      return "yz at x " + Rounded(cut_ ? cut_->slice.center.x : 0, 4);
    case SlicePlane::xy:
      return "xy at z " + Rounded(cut_ ? cut_->slice.center.z : 0, 4);
  }
  return {};
}

}  // namespace ray
