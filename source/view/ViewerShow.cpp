#include <algorithm>
#include <cmath>
#include <filesystem>

#include "R1/Elementary.h"
#include "source/render/LayerColors.h"
#include "source/scene/CameraText.h"
#include "source/text/EnumNames.h"
#include "source/text/NumberText.h"
#include "source/text/Words.h"
#include "source/view/Viewer.h"
#include "source/view/overlay/SceneLines.h"

/// What a viewer shows of what it knows.
namespace ray {
namespace {

constexpr double quad_share_of_distance = 0.25;  // how far the traced picture hangs before its camera
constexpr Rgba frustum_color{255, 255, 120, 255}, picked_color{255, 90, 90, 255}, chosen_color{255, 170, 60, 255},
    text_color{255, 255, 255, 255}, problem_color{255, 196, 186, 255};
constexpr double margin = 0.35;   // of text, in heights of its lines
constexpr double cross_size = 8;  // pixels from the middle of a mark to its end
constexpr double seconds_of_message = 5, seconds_of_fading = 1;

R2::Color InverseOf(const R2::Color& c) { return {1 - c.r, 1 - c.g, 1 - c.b}; }

bool IsLight(RenderMode mode) {
  return mode == RenderMode::whitted || mode == RenderMode::path || mode == RenderMode::albedo;
}

}  // namespace

FrameState Viewer::Show() {
  if (!lines_) {
    lines_ = std::make_shared<const Lines>(MakeLines());
    lines_have_quad_frame_ = ShowsQuad() && !SeesAsTraced();
  }
  FrameState shown;
  shown.size = size_;
  shown.view = ViewSize();
  if (section_.IsShown()) {
    MakeSection();
    shown.section_size = section_size_;
    shown.section = {section_drawing_, &section_drawing_->lines};
  }
  const Exposure exposure{R1::Exp2(exposure_steps_), settings_.render.srgb};
  const R2::Color background = exposure.factor * BackgroundOfPreview();
  shown.background = exposure.srgb ? EncodeSrgb(background) : background;
  shown.seen_from = ViewFrom(CameraOfPicture(), space_, SizeOfPreview(), exposure);
  if (ShowsDepth(settings_.render.mode)) {
    const ZBufferRange depths = DepthsOfPreview();
    shown.seen_from.depths = {static_cast<float>(depths.near / space_.radius),
                              static_cast<float>(depths.far / space_.radius)};
  }
  shown.clip_from_drawing = ClipFromDrawing(CameraOfPicture(), space_, BoxOfDrawing(), SizeOfPreview());
  shown.faces = faces_;
  shown.shows_faces = shows_faces_;
  shown.shows_edges = shows_edges_;
  shown.shows_shadows = shows_shadows_ && settings_.render.trace.shadows;
  shown.edge_color = ray::Shown(InverseOf(shown.background));
  shown.lines = lines_;
  shown.marks = std::make_shared<const Lines>(MakeMarks());
  if (rays_.Look().chosen) shown.lit = std::make_shared<const Lines>(ChosenRay(*rays_.Pixel(), space_, rays_.Look()));
  if (ShowsQuad()) {
    FrameState::Picture quad;
    quad.frame = &pictures_.Trace()->frame();
    quad.number = pictures_.TraceNumber();
    quad.rows = pictures_.Trace()->RowsDone();
    quad.exposure = exposure;
    quad.corners.emplace();
    const auto corners = QuadCorners();
    for (std::size_t i = 0; i < corners.size(); ++i) (*quad.corners)[i] = space_.At(corners[i]);
    shown.quad = quad;
  }
  shown.picture = CoveringPicture();
  ShowFlat(shown);
  shown.line_width = LineWidth();
  shown.labels = MakeLabels();
  if (!shown.labels.empty() || shows_panels_ || shows_help_) shown.panels = panels_->Draw(*this, shown.labels);
  return shown;
}

ZBufferRange Viewer::DepthsOfPreview() const {
  const ZBufferRange& given = settings_.render.trace.zbuffer;
  if (settings_.render.mode == RenderMode::zbuffer && !given.IsOfPicture()) return given;
  constexpr int across = 64;  // rays each way: what is between them is hardly nearer or farther
  const Camera camera = CameraOfPicture();
  ZBufferRange range{R3::infinity, 0};
  Workspace workspace;
  for (int row = 0; row < across; ++row)
    for (int column = 0; column < across; ++column) {
      const double x = (column + 0.5) / across, y = (row + 0.5) / across;
      const R3::Ray ray = camera.Through(x * SizeOfPreview().width, y * SizeOfPreview().height, SizeOfPreview().width,
                                         SizeOfPreview().height);
      const auto hit = scene_->accelerator->Intersect(ray, workspace);
      if (!hit) continue;
      const double distance = hit->t * Length(ray.direction);
      range = {std::min(range.near, distance), std::max(range.far, distance)};
    }
  return range.far > 0 ? range : ZBufferRange{0, 1};
}

R2::Color Viewer::BackgroundOfPreview() const {
  switch (settings_.render.mode) {
    case RenderMode::depth:
    case RenderMode::uv:
    case RenderMode::normal_color:
    case RenderMode::uv_color:
    case RenderMode::zbuffer:
      return {};
    case RenderMode::normal:
      return {0.5, 0.5, 0.5};
    case RenderMode::whitted:
    case RenderMode::path:
    case RenderMode::heat:
    case RenderMode::rays:
    case RenderMode::albedo:
    case RenderMode::id:
    case RenderMode::flat:
    case RenderMode::gooch:
    case RenderMode::toon:
    case RenderMode::hatching:
      break;
  }
  return scene_->parsed.scene.background;
}

R3::Box Viewer::BoxToFrame() const {
  R3::Box box = scene_->parsed.scene.root.bounds;
  if (!shows_lights_) return box;
  for (const auto& light : scene_->parsed.scene.lights) {
    const LightBound bound = light->Bound();
    const R3::Vector reach{bound.radius, bound.radius, bound.radius};
    if (!light->IsBlack() && !bound.is_infinite) box.Extend(bound.center - reach), box.Extend(bound.center + reach);
  }
  return box;
}

R3::Box Viewer::BoxOfDrawing() const {
  R3::Box box = BoxToFrame();
  const bool has_rays = rays_.ShowsGrid() || rays_.Pixel(), has_planes = !scene_->world.Unbounded().empty();
  if ((has_rays || has_planes) && !box.IsEmpty()) {  // they go beyond the scene
    const double reach = (has_planes ? times_the_scene : 2) * box.Radius();
    box = {box.low - R3::Vector{reach, reach, reach}, box.high + R3::Vector{reach, reach, reach}};
  }
  if (!ShowsQuad()) return box;
  box.Extend(pictures_.Trace()->Settings().view.value_or(scene_->parsed.scene.camera).eye);
  for (const R3::Point& corner : QuadCorners()) box.Extend(corner);
  return box;
}

std::optional<FrameState::Picture> Viewer::CoveringPicture() const {
  FrameState::Picture picture;
  picture.exposure = {R1::Exp2(exposure_steps_), settings_.render.srgb};
  picture.place = PlaceOfPicture();
  if (auto compared = pictures_.Compared()) {
    picture.image = std::move(compared);
    if (pictures_.ShowsEncodedDifference()) picture.exposure.srgb = false;
    if (pictures_.ShowsFalseColors()) picture.exposure = {};
    return picture;
  }
  if (FlatJob() && !pictures_.IsLive()) {
    picture.frame = &pictures_.Trace()->frame();
    picture.number = pictures_.TraceNumber();
    picture.rows = pictures_.Trace()->RowsDone();
    return picture;
  }
  if (!pictures_.ShownLive()) return {};
  const RenderJob& job = *pictures_.ShownLive();
  const RenderMode mode = job.Settings().mode;
  if (IsLight(mode)) {
    picture.frame = &job.frame();
    picture.number = pictures_.ShownLiveNumber();
  } else {
    // Colors that stand for something else than light: as image files show them.
    picture.image = std::make_shared<const R2::Image>(LayerAsShown(mode, *TracedPictures::ImageOf(job.frame())));
    picture.exposure = {};
  }
  return picture;
}

std::array<R3::Point, 4> Viewer::QuadCorners() const {
  const RenderSettings& traced = pictures_.Trace()->Settings();
  const Camera camera = traced.view.value_or(scene_->parsed.scene.camera);
  const double to_middle = DepthOf(camera, navigator_.Center());
  const double distance = quad_share_of_distance * (to_middle > 0 ? to_middle : space_.radius);
  const auto corner = [&](double x, double y) {
    return camera.Through(x, y, traced.width, traced.height).At(distance);
  };
  const double w = traced.width, h = traced.height;
  return {corner(0, 0), corner(w, 0), corner(w, h), corner(0, h)};
}

bool Viewer::SeesAsTraced() const {
  const RenderSettings& traced = pictures_.Trace()->Settings();
  const DrawingSize view = ViewSize();
  return CameraLine(traced.view.value_or(scene_->parsed.scene.camera)) == CameraLine(navigator_.camera()) &&
         std::int64_t{traced.width} * view.height == std::int64_t{traced.height} * view.width;
}

std::optional<std::pair<int, int>> Viewer::PixelOnQuad(const R2::Point& position) const {
  if (!ShowsQuad()) return {};
  const auto corners = QuadCorners();
  const R3::Vector across = corners[1] - corners[0], upward = corners[3] - corners[0], normal = Cross(across, upward);
  const R3::Ray ray = navigator_.camera().Through(position.x, position.y, ViewSize().width, ViewSize().height);
  const double t = Dot(corners[0] - ray.origin, normal) / Dot(ray.direction, normal);
  if (!(t > 0)) return {};
  const R3::Vector way = ray.At(t) - corners[0];
  const RenderSettings& traced = pictures_.Trace()->Settings();
  const double x = Dot(way, across) / Dot(across, across) * traced.width;
  const double y = Dot(way, upward) / Dot(upward, upward) * traced.height;
  if (!(x >= 0 && y >= 0 && x < traced.width && y < traced.height)) return {};
  // What stands before the quad is meant rather than it.
  const auto nearer = PointAt(position);
  if (nearer && Length(*nearer - ray.origin) < Length(ray.At(t) - ray.origin)) return {};
  return std::pair{static_cast<int>(x), static_cast<int>(y)};
}

Lines Viewer::MakeLines() const {
  Lines lines = SceneLineLines(scene_->world, space_);
  if (boxes_ == Boxes::nodes) Append(lines, NodeBoxLines(scene_->world, space_, box_level_).lines);
  if (boxes_ == Boxes::accelerator) Append(lines, AcceleratorBoxLines(*scene_->accelerator, space_, box_level_).lines);
  if (chosen_node_ && shows_panels_) Append(lines, NodeBoxOf(scene_->world, space_, *chosen_node_, chosen_color));
  if (shows_lights_) Append(lines, LightLines(scene_->parsed.scene, space_));
  if (shows_camera_) {
    const Camera& own = scene_->parsed.scene.camera;
    Append(lines,
           CameraLines(own, size_.width, size_.height, space_.radius * quad_share_of_distance, space_, frustum_color));
  }
  if (ShowsQuad() && !SeesAsTraced()) {
    const RenderSettings& traced = pictures_.Trace()->Settings();
    const Camera camera = traced.view.value_or(scene_->parsed.scene.camera);
    const double distance = Length(QuadCorners()[0] - camera.eye) > 0 ? DepthOf(camera, QuadCorners()[0]) : 0;
    Append(lines, CameraLines(camera, traced.width, traced.height, distance, space_, frustum_color));
  }
  // Each by itself: what fades among many rays of the grid must not take those of a pixel along.
  if (rays_.ShowsGrid()) Append(lines, RayLines(rays_.Grid(), space_, rays_.Look().WithoutChoice()));
  if (rays_.Pixel()) Append(lines, RayLines({*rays_.Pixel()}, space_, rays_.Look()));
  return lines;
}

Lines Viewer::MakeMarks() const {
  Lines lines;
  const Camera& camera = navigator_.camera();
  const auto size_at = [&](const R3::Point& p) {
    return cross_size * std::max(0.0, DepthOf(camera, p)) * 2 * camera.HalfWidth() / ViewSize().width;
  };
  if (const auto& pivot = navigator_.Pivot()) Append(lines, AxesAt(*pivot, size_at(*pivot), space_));
  if (shows_panels_ || editor_.IsDragging()) Append(lines, editor_.Marks(*this, space_, size_at));
  if (pick_ && pick_->point) Append(lines, CrossAt(*pick_->point, size_at(*pick_->point), space_, picked_color));
  return lines;
}

int Viewer::LineWidth() const { return std::max(1, static_cast<int>(std::lround(scale_))); }

double Viewer::StrengthOfMessage() const {
  return std::clamp((message_since_ + seconds_of_message - now_) / seconds_of_fading, 0.0, 1.0);
}

std::vector<Label> Viewer::MakeLabels() const {
  const double strength = StrengthOfMessage();
  const bool has_message = !message_.empty() && strength > 0;
  // Above the view, whole texts, and their colors.
  std::vector<std::pair<std::string, Rgba>> upper;
  if (!scene_problems_.empty()) upper.emplace_back(TextOfProblems(), problem_color);
  if (section_.IsShown()) {
    upper.emplace_back("cross section: " + section_.Describe(size_.height), text_color);
    if (std::string text = TextOfSection(); !text.empty()) upper.emplace_back(std::move(text), text_color);
  }
  if (std::string text = pictures_.ScaleOfComparison(); !text.empty()) upper.emplace_back(std::move(text), text_color);
  if (std::string text = TextOfProjection(); !text.empty()) upper.emplace_back(std::move(text), text_color);
  if (pick_ && !shows_panels_)
    for (const std::string& text : pick_->text) upper.emplace_back(text, text_color);

  std::vector<Label> labels;
  if (upper.empty() && !has_message && !FlatJob()) return labels;
  const LetterSize letters = panels_->Letters();
  const double edge = letters.height * margin;
  const int columns = static_cast<int>((ViewSize().width - 2 * edge) / letters.width);
  if (section_.IsShown())
    for (Label label : section_drawing_->labels) label.x += ViewSize().width, labels.push_back(std::move(label));
  AddLabelsOfFlat(labels, letters);
  double y = ViewSize().height - letters.height - edge;
  for (const auto& [text, color] : upper)
    for (const std::string& line : InLines(text, columns)) {
      labels.push_back({edge, y, line, color});
      y -= letters.height;
    }
  if (!has_message) return labels;
  const auto lines = InLines(message_, columns);
  y = edge + static_cast<double>(lines.size() - 1) * letters.height;
  for (const std::string& line : lines) {
    labels.push_back({edge, y, line, {255, 255, 255, static_cast<std::uint8_t>(255 * strength)}});
    y -= letters.height;
  }
  return labels;
}

std::string Viewer::TextOfProblems() const {
  if (scene_problems_.empty()) return {};
  const SceneError& first = scene_problems_.front();
  std::string text = first.file;
  if (first.line > 0) text += ":" + std::to_string(first.line) + ":" + std::to_string(first.column);
  text += (text.empty() ? "" : ": ") + first.message.substr(0, first.message.find('\n'));
  const std::size_t more = scene_problems_.size() - 1;
  if (more > 0) text += ", and " + Counted(more, "more mistake");
  return text + (problem_file_ == settings_.scene ? ". The scene from before is shown until the file is right."
                                                  : ". Escape closes this.");
}

std::string Viewer::TextOfProjection() const {
  const Camera& camera = navigator_.camera();
  if (camera.IsPinhole() || flat_.IsShown() || pictures_.IsLive()) return {};
  return std::string("preview of a pinhole; S traces the true projection, ") + camera.kind->name;
}

std::string Viewer::BoxesInWords() const {
  if (boxes_ == Boxes::none) return "no boxes";
  const std::string level = box_level_ == all_levels ? "of all levels" : "of level " + std::to_string(box_level_);
  const BoxLines boxes = boxes_ == Boxes::nodes ? NodeBoxLines(scene_->world, space_, box_level_)
                                                : AcceleratorBoxLines(*scene_->accelerator, space_, box_level_);
  return std::to_string(boxes.boxes) + (boxes.boxes == 1 ? " box" : " boxes") +
         (boxes_ == Boxes::nodes ? " of nodes " : " of the accelerator ") + level +
         (boxes.left_out > 0 ? ", " + std::to_string(boxes.left_out) + " left out" : "");
}

std::string Viewer::Title() const {
  const std::string name = std::filesystem::path(settings_.scene).filename().string();
  return name + (editor_.HasUnsaved() ? "* " : " ") + std::to_string(size_.width) + "x" + std::to_string(size_.height) +
         (scene_problems_.empty() ? "" : " (mistakes in " + problem_file_ + ")") +
         (status_.empty() ? "" : " " + status_) + (notes_.empty() ? "" : " (" + notes_ + ")");
}

std::string Viewer::State() {
  std::string text;
  const auto line = [&](const std::string& name, const std::string& value) { text += name + " " + value + "\n"; };
  const auto yes_or_no = [](bool is) { return is ? "yes" : "no"; };
  line("scene", settings_.scene);
  line("size", std::to_string(size_.width) + " " + std::to_string(size_.height));
  text += CameraLine(navigator_.camera()) + "\n";
  line("faces", yes_or_no(shows_faces_));
  line("edges", yes_or_no(shows_edges_));
  line("lights", yes_or_no(shows_lights_));
  line("shadows", yes_or_no(shows_shadows_));
  line("frustum", yes_or_no(shows_camera_));
  line("quad", yes_or_no(ShowsQuad()));
  line("boxes", BoxesInWords());
  line("turntable", yes_or_no(navigator_.IsTurntable()));
  line("pivot", yes_or_no(navigator_.Pivot().has_value()));
  line("live", pictures_.IsLive() ? NameOf(pictures_.LiveMode().value_or(settings_.render.mode)) : "no");
  line("status", status_);
  line("trace", !pictures_.Trace()                ? "none"
                : pictures_.IsTracing()           ? "running"
                : pictures_.Trace()->IsComplete() ? "complete"
                                                  : "stopped");
  line("flat",
       flat_.IsShown() ? "zoom " + Rounded(flat_.ZoomFactor(), 4) + " slider " + Rounded(flat_.Slider(), 4) : "no");
  line("grid", std::to_string(rays_.ShowsGrid() ? rays_.Grid().size() : 0));
  line("pixel",
       rays_.Pixel() ? std::to_string(rays_.Pixel()->column) + " " + std::to_string(rays_.Pixel()->row) : "none");
  const RayLook& look = rays_.Look();
  std::string kinds;
  for (const bool shows : look.shows) kinds += shows ? '1' : '0';
  line("rays", kinds + (look.normals ? "1" : "0") + " deepest " + std::to_string(look.deepest));
  if (const std::string place = TextOfSection(); !place.empty()) line("under the pointer", place);
  line("cut", section_.IsShown() ? section_.Describe(size_.height) : "no");
  line("exposure", ToText(exposure_steps_));
  line("comparing", std::to_string(static_cast<int>(pictures_.HowCompared())));
  line("reference", yes_or_no(pictures_.Reference() != nullptr));
  line("help", yes_or_no(shows_help_));
  line("problem", TextOfProblems());
  line("message", message_);
  line("edits", editor_.Describe());
  line("panels", yes_or_no(shows_panels_));
  text += TextOfPanels();
  return text;
}

}  // namespace ray
