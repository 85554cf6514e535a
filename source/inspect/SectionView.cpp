#include "source/inspect/SectionView.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>

#include "R1/Elementary.h"
#include "source/inspect/SliceView.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr int cut_lines = 512;  // of the grid that searches, each way
constexpr double step = 0.02;   // of the axis planes, in radii of the scene
constexpr double crossing_normal_length = 0.03;
constexpr Rgba crossing_normal_color{255, 120, 220, 160};
constexpr double normal_spacing = 0.04;  // between neighbors of one outline, in half sides of the slice
// Rays are projected: where they are off the plane they are fainter, so that none seems to cross what it passes by.
constexpr int pieces_of_ray = 16;
constexpr double near_plane = 0.02;  // half sides of the slice away, where a ray has lost half of its alpha
constexpr double faintest_of_row = 0.12, faintest_of_axes = 0.35;  // of axis planes most rays are projected
constexpr Rgba camera_color{255, 230, 120, 255}, screen_color{120, 255, 160, 255};
constexpr double dot_radius = 0.25;       // heights of a line of text
constexpr double way_to_screen = 0.25;    // of the scene's radius, where no lens has a focus distance
constexpr double room_behind_eye = 0.1;   // of its way from the middle of the scene
constexpr double farthest_shown_eye = 5;  // radii from the middle of the scene; beyond, too little would be left of it

R3::Vector NormalOf(SlicePlane plane) {
  const auto is = [&](SlicePlane other) { return plane == other ? 1.0 : 0.0; };
  return {is(SlicePlane::yz), is(SlicePlane::xz), is(SlicePlane::xy)};
}

/// The names of the axes that run to the right and upward.
std::array<std::string, 2> NamesOfAxes(SlicePlane plane) {
  return {plane == SlicePlane::yz ? "z" : "x", plane == SlicePlane::xz ? "z" : "y"};
}

}  // namespace

void SectionView::NextPlane() {
  constexpr std::array order{SlicePlane::camera_row, SlicePlane::xz, SlicePlane::yz, SlicePlane::xy};
  const auto now = std::ranges::find(order, plane_);
  plane_ = now + 1 == order.end() ? order.front() : now[1];
}

bool SectionView::MoveTo(int row) {
  if (plane_ != SlicePlane::camera_row || row == row_) return false;
  row_ = row;
  return true;
}

void SectionView::Move(int by, int height) {
  if (plane_ == SlicePlane::camera_row)
    row_ = std::clamp(Row(height) + by, 0, height - 1);
  else
    offset_ += step * by;
}

void SectionView::Cut(const LoadedScene& scene, const RenderSettings& settings, const R3::Point& center,
                      const DrawingSize& size, const DebugRayCounts& counts) {
  R3::Box box = scene.parsed.scene.root.bounds;
  const double radius = box.Radius() > 0 ? box.Radius() : 1;
  const Camera camera = settings.view.value_or(scene.parsed.scene.camera);
  Slice slice;
  PixelLine line{plane_ == SlicePlane::yz, plane_ == SlicePlane::yz ? settings.width / 2 : settings.height / 2};
  if (plane_ == SlicePlane::camera_row) {
    constexpr double middle = 0.5;  // of the row
    line.at = Row(settings.height);
    slice = CameraSlice(camera, line.at + middle, settings.width, settings.height, box);
    coordinates_ = {{"right", "ahead"}, slice.Project(camera.eye), "the eye"};
  } else {
    slice = AxisSlice(plane_, center + offset_ * radius * NormalOf(plane_), box);
    coordinates_ = {NamesOfAxes(plane_), slice.Project(R3::Point{}), "the origin"};
  }
  TraceLine(scene, settings, line, counts);
  mark_ = MarkOf(camera, line, settings, slice, radius);
  // A little behind the eye too, so that the numbers along the edge are not over its dot.
  const R3::Vector way = camera.eye - box.Center();
  if (!box.IsEmpty() && Length(way) < farthest_shown_eye * radius) box.Extend(camera.eye + room_behind_eye * way);
  view_ = SliceView::Of(slice, box, size);
  cut_ = CutOf(scene.world, *scene.accelerator, slice, cut_lines);
}

void SectionView::TraceLine(const LoadedScene& scene, const RenderSettings& settings, const PixelLine& line,
                            const DebugRayCounts& counts) {
  rays_.clear();
  const PixelTracer tracer(scene.world, *scene.accelerator, counts.Thinned(settings));
  const int end = line.is_column ? settings.height : settings.width;
  for (int i = 0; i < end; i += std::max(1, end / counts.in_cut))
    rays_.push_back(line.is_column ? tracer.Trace(line.at, i, 1) : tracer.Trace(i, line.at, 1));
}

SliceAxes SectionView::Drawing(const LoadedScene& scene, const RayLook& look, const LetterSize& letters,
                               int line_width) const {
  SliceAxes drawing = AxesOf(view_, coordinates_, letters);
  Append(drawing.lines, CutFilling(*cut_, scene.world, view_, line_width));
  Append(drawing.lines, CutLines(*cut_, scene.world, view_));
  AddNormals(drawing.lines);
  AddRays(drawing.lines, look);
  if (mark_) AddMark(drawing.lines, dot_radius * letters.height);
  return drawing;
}

/// One of the crossings of an instance in each cell of a grid of squares.
void SectionView::AddNormals(Lines& lines) const {
  const Slice& slice = cut_->slice;
  std::set<std::array<std::int64_t, 3>> taken;
  const double side = normal_spacing * slice.extent;
  const auto cell = [&](double x) { return static_cast<std::int64_t>(std::floor(x / side)); };
  for (const Crossing& crossing : cut_->crossings) {
    if (!taken.insert({crossing.instance, cell(crossing.on_slice.x), cell(crossing.on_slice.y)}).second) continue;
    const R2::Point tip = crossing.on_slice + crossing_normal_length * slice.extent * crossing.normal;
    AddLine(lines, view_.At(crossing.on_slice), view_.At(tip), crossing_normal_color);
  }
}

/// Rays are drawn in a space of their own, and projected onto the plane from there.
void SectionView::AddRays(Lines& lines, const RayLook& look) const {
  const Slice& slice = cut_->slice;
  const double faintest = plane_ == SlicePlane::camera_row ? faintest_of_row : faintest_of_axes;
  const R3::Vector normal = Cross(slice.u, slice.v);
  const Lines in_space = RayLines(rays_, DrawingSpace{slice.center, slice.extent}, look);
  for (std::size_t i = 0; i + 1 < in_space.size(); i += 2) {
    const auto vertex = [&](int piece) {
      const double share = static_cast<double>(piece) / pieces_of_ray;
      const auto along = [&](std::size_t k) {
        const double from = in_space[i].at[k], to = in_space[i + 1].at[k];
        return (1 - share) * from + share * to;
      };
      const R3::Vector way{along(0), along(1), along(2)};
      const double off = Dot(way, normal) / near_plane;
      Rgba color = in_space[i].color;
      color[3] = static_cast<std::uint8_t>(color[3] * (faintest + (1 - faintest) / (1 + off * off)));
      return Vertex{view_.At(slice.Project(slice.center + slice.extent * way)), color};
    };
    for (int piece = 0; piece < pieces_of_ray; ++piece) {
      lines.push_back(vertex(piece));
      lines.push_back(vertex(piece + 1));
    }
  }
}

SectionView::CameraMark SectionView::MarkOf(const Camera& camera, const PixelLine& line, const RenderSettings& settings,
                                            const Slice& slice, double scene_radius) {
  const double way = settings.camera.HasLens() ? settings.camera.focus : way_to_screen * scene_radius;
  const double middle = line.at + 0.5;
  const auto on_screen = [&](double along) {
    const R2::Point p = line.is_column ? R2::Point{middle, along} : R2::Point{along, middle};
    // Directions are 1 long along the axis.
    return slice.Project(camera.eye + way * camera.Through(p.x, p.y, settings.width, settings.height).direction);
  };
  return {slice.Project(camera.eye), on_screen(0), on_screen(line.is_column ? settings.height : settings.width)};
}

/// A dot, of a line for each row of pixels, and the line of the screen.
void SectionView::AddMark(Lines& lines, double radius) const {
  AddLine(lines, view_.At(mark_->left), view_.At(mark_->right), screen_color);
  const R2::Point eye = view_.Pixel(mark_->eye);
  const auto at = [&](double x, double y) { return view_.At(view_.InSlice({x, y})); };
  for (double y = -radius + 0.5; y < radius; ++y) {
    const double half = std::sqrt(radius * radius - y * y);
    AddLine(lines, at(eye.x - half, eye.y + y), at(eye.x + half, eye.y + y), camera_color);
  }
}

std::string SectionView::DescribePlace(const R2::Point& pixel, const std::optional<R2::Point>& from) const {
  const auto length = [](const R2::Vector& v) { return Plain(R1::Hypot(v.x, v.y), 4); };
  const R2::Point at = view_.InSlice(pixel);
  const R2::Vector way = at - coordinates_.origin;
  return coordinates_.names[0] + " " + Plain(way.x, 4) + ", " + coordinates_.names[1] + " " + Plain(way.y, 4) + ": " +
         length(way) + " from " + coordinates_.origin_name +
         (from ? ", " + length(at - view_.InSlice(*from)) + " from where the button went down" : "");
}

std::string SectionView::Describe(int height) const {
  switch (plane_) {
    case SlicePlane::camera_row:
      return "row " + std::to_string(Row(height));
    case SlicePlane::xz:
      return "xz at y " + Plain(cut_ ? cut_->slice.center.y : 0, 4);
    case SlicePlane::yz:
      return "yz at x " + Plain(cut_ ? cut_->slice.center.x : 0, 4);
    case SlicePlane::xy:
      return "xy at z " + Plain(cut_ ? cut_->slice.center.z : 0, 4);
  }
  return {};
}

}  // namespace ray
