#include "source/view/Viewer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "R1/Elementary.h"
#include "source/scene/CameraText.h"
#include "source/text/EnumNames.h"
#include "source/text/Words.h"
#include "source/view/live/JobStatus.h"
#include "source/view/overlay/SceneLines.h"

namespace ray {
namespace {

constexpr double click_reach = 4;                  // pixels that a click may move
constexpr double double_click_time = 0.4;          // seconds
constexpr double seconds_between_looks = 0.25;     // at the scene's files
constexpr double seconds_between_statuses = 0.25;  // slow enough for digits to be read

std::shared_ptr<const LoadedScene> Load(const std::string& file, const ViewerSettings& settings) {
  return std::make_shared<LoadedScene>(file, settings.parse, settings.accelerator);
}

std::string FirstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

Viewer::Viewer(ViewerSettings settings, std::shared_ptr<const LoadedScene> scene, ViewerHost& host)
    : settings_(std::move(settings)),
      host_(host),
      scene_(std::move(scene)),
      bookmarks_(settings_.scene),
      navigator_(scene_->parsed.scene.camera, scene_->parsed.scene.root.bounds,
                 {settings_.render.width, settings_.render.height}),
      panels_(MakePanels()),
      size_{settings_.render.width, settings_.render.height},
      box_level_(all_levels) {
  panels_->SetLook(settings_.panels);
  pictures_.SetReference(settings_.reference);
  TakeScene(scene_);
}

void Viewer::TakeScene(std::shared_ptr<const LoadedScene> scene) {
  scene_ = std::move(scene);
  ++scene_number_;
  chosen_node_.reset();
  if (accelerators_) {
    accelerators_->Stop();
    ending_comparisons_.push_back(std::move(accelerators_));
  }
  scene_problems_.clear();
  const R3::Box& box = scene_->parsed.scene.root.bounds;
  space_ = DrawingSpace::Of(box);
  navigator_.SetBox(box);
  MakeFaces();
  watch_.Watch(scene_->parsed.scene.files);
  rays_.ForgetAll();
  pick_.reset();
  section_drawing_.reset();
  pictures_.Touch();
  InvalidateLines();
}

void Viewer::MakeFaces() {
  pictures_.SetEncoding({settings_.render.srgb, settings_.render.quantization});
  ScenePicture picture = PictureOf(scene_->world, settings_.render, space_);
  notes_.clear();
  if (picture.as_boxes > 0)
    AddNote(Counted(static_cast<std::uint64_t>(picture.as_boxes), "primitive") + " shown as boxes");
  if (picture.left_out > 0) AddNote(std::to_string(picture.left_out) + " not shown");
  if (picture.lights.left_out > 0)
    AddNote(Counted(static_cast<std::uint64_t>(picture.lights.left_out), "weaker light") + " left out of the preview");
  const RenderMode mode = settings_.render.mode;
  if (mode != RenderMode::whitted)
    AddNote(std::string("mode ") + NameOf(mode) + (IsPreviewed(mode) ? "" : ", which the preview does not show"));
  if (picture.lights.head_light) AddNote("the scene is unlit: seen by a light at the eye");
  faces_ = std::make_shared<const ScenePicture>(std::move(picture));
}

void Viewer::AddNote(const std::string& note) { notes_ += (notes_.empty() ? "" : ", ") + note; }

RenderSettings Viewer::SettingsOfView() const {
  RenderSettings settings = settings_.render;
  settings.width = size_.width;
  settings.height = size_.height;
  const Camera &own = scene_->parsed.scene.camera, &now = navigator_.camera();
  // The scene's own view is left unsaid, so that the same command as without a viewer makes the same picture.
  if (CameraLine(now) != CameraLine(own)) settings.view = now;
  return settings;
}

void Viewer::ShowMessage(const std::string& message) {
  message_ = message;
  message_since_ = now_;
  needs_redraw_ = true;
}

void Viewer::Handle(const Event& event) {
  if (shows_panels_ || shows_help_) {
    needs_redraw_ |= !std::holds_alternative<TickEvent>(event);
    const bool is_taken = panels_->Take(event, *this);
    const auto* button = std::get_if<ButtonEvent>(&event);
    if (button && !button->is_pressed) editor_.DoHeld();
    // Whatever panels came up since the press: a drag that nobody ends would go on for ever.
    const bool ends_press = button && !button->is_pressed && press_ && press_->button == button->button;
    if (is_taken && !ends_press) return;
  }
  std::visit([this](const auto& e) { On(e); }, event);
  navigator_.SetSize(ViewSize());
}

void Viewer::On(const KeyEvent& event) {
  if (navigator_.HoldKey(event)) {
    if (press_) press_->is_click = false;
    return;
  }
  if (!event.is_pressed) {
    // Whatever other keys are held by now.
    for (const Binding& binding : Bindings())
      if (binding.key == event.key && binding.release) binding.release(*this);
    return;
  }
  for (const Binding& binding : Bindings()) {
    if (binding.key != event.key || binding.modifiers != event.modifiers) continue;
    if (event.key != Key::q) was_asked_to_quit_ = false;
    const std::string before = std::exchange(message_, {});
    binding.act(*this);
    // What was seen last is what is saved, of the end and of a screenshot.
    if (is_closed_ || message_.empty()) message_ = before;
    needs_redraw_ = true;
    return;
  }
}

void Viewer::On(const ButtonEvent& event) {
  if (event.is_pressed) {
    if (press_) return;  // a second button while one is held
    press_ = Press{event.button, {event.x, event.y}};
    press_->on_section = IsOnSection(press_->at);
    press_->moves_flat = FlatJob() && !press_->on_section;
    press_->moves_slider = press_->moves_flat && TakesSlider(event);
    if (press_->on_section || press_->moves_flat) return;
    constexpr Modifiers of_moving{true, true};
    press_->moves_chosen = event.button == Button::left && event.modifiers == of_moving;
    if (press_->moves_chosen) {
      editor_.BeginDrag(*this, RayAt(press_->at));
      return;
    }
    navigator_.BeginDrag(event, PointFinder());
    return;
  }
  if (!press_ || press_->button != event.button) return;
  const bool is_click = press_->is_click && !press_->on_section;
  editor_.EndDrag(*this);
  needs_redraw_ |= press_->on_section;
  press_.reset();
  navigator_.EndDrag();
  if (is_click) OnClick(event);
}

void Viewer::On(const MoveEvent& event) {
  needs_redraw_ |= IsOnSection(pointer_) || IsOnSection({event.x, event.y});
  const R2::Point last = std::exchange(pointer_, {event.x, event.y});
  if (!press_ || press_->on_section) return;
  const bool has_gone = R1::Hypot(event.x - press_->at.x, event.y - press_->at.y) > click_reach;
  press_->is_click = press_->is_click && !has_gone;
  if (press_->is_click) return;
  if (press_->moves_flat) return DragFlat(last, pointer_);
  if (press_->moves_chosen) return editor_.DragTo(*this, RayAt(pointer_));
  navigator_.DragTo({event.x, event.y});
}

void Viewer::OnClick(const ButtonEvent& event) {
  const R2::Point position{event.x, event.y};
  if (event.button == Button::right) return DebugPixelAt(position);
  if (event.button != Button::left || event.modifiers != Modifiers{}) return;
  const bool is_near = R1::Hypot(position.x - last_click_at_.x, position.y - last_click_at_.y) <= click_reach;
  const bool is_second = last_click_ >= 0 && now_ - last_click_ <= double_click_time && is_near;
  last_click_ = is_second ? -1 : now_;
  last_click_at_ = position;
  if (is_second && !FlatJob()) {
    navigator_.SetPivot(PointAt(position));
    ShowMessage(navigator_.Pivot() ? "pivot set" : "pivot reset to the center of the scene");
    return InvalidateLines();
  }
  PickAt(InPicture(position));
}

void Viewer::PickAt(const R2::Point& position) {
  const RenderSettings settings = SettingsOfPicture();
  if (position.x < 0 || position.y < 0 || position.x >= settings.width || position.y >= settings.height) return;
  pick_ = PickPixel(scene_->world, *scene_->accelerator, settings, static_cast<int>(position.x),
                    static_cast<int>(position.y));
  for (const std::string& line : pick_->text) host_.Print(line);
  chosen_node_.reset();
  const auto& nodes = scene_->world.Nodes();
  for (std::size_t i = 0; pick_->point && i < nodes.size(); ++i)
    if (nodes[i].instance == static_cast<std::int32_t>(pick_->instance)) chosen_node_ = i;
  InvalidateLines();
}

void Viewer::On(const ScrollEvent& event) {
  if (IsOnSection({event.x, event.y}) && !press_) return MoveSection(event.steps < 0 ? -1 : 1);
  if (FlatJob()) return ZoomFlat(event);
  navigator_.Scroll(event, PointFinder());
}

void Viewer::On(const ResizeEvent& event) {
  const DrawingSize size{std::max(1, event.width), std::max(1, event.height)};
  scale_ = event.scale;
  panels_->SetScale(scale_);
  section_drawing_.reset();
  if (size == size_) return;
  size_ = size;
  pictures_.Touch();
  InvalidateLines();
}

void Viewer::On(const DropEvent& event) { Open(event.file); }

void Viewer::On(const TickEvent& event) {
  // Not before time passes: a script that only draws gets the scene alone.
  if (!std::exchange(has_ticked_, true) && message_.empty())
    ShowMessage("H: help" + (notes_.empty() ? "" : "; " + notes_));
  const double strength = StrengthOfMessage();
  now_ += event.seconds;
  if (StrengthOfMessage() != strength) needs_redraw_ = true;
  navigator_.Advance(event.seconds);
  if (now_ - last_look_at_files_ < seconds_between_looks) return;
  last_look_at_files_ = now_;
  if (watch_.HasChanged()) TellOfChangedFiles();
}

bool Viewer::Update() {
  if (navigator_.Changes() != changes_seen_) {
    changes_seen_ = navigator_.Changes();
    pictures_.TouchView();
    section_drawing_.reset();
    if (ShowsQuad() && SeesAsTraced() == lines_have_quad_frame_) InvalidateLines();
    needs_redraw_ = true;
  }
  pictures_.Update(scene_, SettingsOfView(), settings_.live_is_endless);
  if (const RenderJob* job = pictures_.TakeEnded()) SaveEnded(*job);
  if (const RenderJob* job = pictures_.TakeEndedLive()) TellEndedLive(*job);
  UpdateStatus();

  std::erase_if(ending_comparisons_, [](const auto& comparison) { return comparison->HasEnded(); });
  if (accelerators_ && accelerators_->Version() != accelerators_seen_) {
    accelerators_seen_ = accelerators_->Version();
    needs_redraw_ = true;
  }

  // Rows that were written since the last look.
  std::vector<std::uint32_t> versions;
  for (const RenderJob* job : {pictures_.Trace(), pictures_.Live()})
    for (int row = 0; job && row < job->frame().Height(); ++row) versions.push_back(job->frame().Version(row));
  if (versions != versions_) {
    versions_ = std::move(versions);
    needs_redraw_ = true;
  }
  return std::exchange(needs_redraw_, false);
}

void Viewer::SaveEnded(const RenderJob& job) {
  if (!job.Failure().empty()) return ShowMessage("rendering failed: " + job.Failure());
  if (!job.IsComplete())
    return ShowMessage("rendering stopped; nothing was saved" +
                       std::string(job.Canceled() ? "; S continues it while view and options are the same" : ""));
  KeepImage(job);
  ShowMessage(host_.SaveTraced(job) + (editor_.HasUnsaved() ? "; the scene's changes are not saved yet" : ""));
}

void Viewer::TellEndedLive(const RenderJob& job) {
  if (!job.Failure().empty()) return ShowMessage("rendering failed: " + job.Failure());
  if (job.IsComplete()) KeepImage(job);
  if (job.IsComplete() && job.Settings().budget.IsOpen()) ShowMessage(ClaimOf(*job.Result()));
}

void Viewer::UpdateStatus() {
  const RenderJob* job = pictures_.IsLive() ? pictures_.Live() : pictures_.Trace();
  if (!job) return status_.clear();
  const std::uint64_t number = pictures_.IsLive() ? pictures_.LiveNumber() : pictures_.TraceNumber();
  const auto now = [&] { return StatusKey{number, job->Samples(), job->HasEnded()}; };
  const bool is_recent = now_ - status_since_ < seconds_between_statuses;
  if (now() == status_of_ && (status_of_.has_ended || is_recent)) return;
  status_since_ = now_;
  do {  // again where a pass has ended meanwhile
    status_of_ = now();
    status_ = StatusOf(*job);
  } while (now() != status_of_);
}

void Viewer::Reload() {
  try {
    auto scene = Load(settings_.scene, settings_);
    TakeSettings(scene->parsed.scene);
    const bool showed_nothing = scene_->world.Instances().empty();
    TakeScene(std::move(scene));
    if (showed_nothing) navigator_.Go(scene_->parsed.scene.camera);
    ShowMessage("scene reloaded" + (notes_.empty() ? "" : "; " + notes_));
  } catch (const std::exception& error) {
    // The scene that is shown stays until the new one can be read.
    TellProblems(settings_.scene, error);
  }
}

void Viewer::TakeSettings(const Scene& scene) {
  const auto settings = host_.SettingsWith(scene);
  if (!settings) return;
  settings_.render = settings->render;
  settings_.live_is_endless = settings->live_is_endless;
}

void Viewer::TellProblems(const std::string& file, const std::exception& error) {
  const auto* errors = dynamic_cast<const SceneErrors*>(&error);
  SceneError other;
  other.file = file;
  other.message = error.what();
  problem_file_ = file;
  scene_problems_ = errors ? errors->All() : std::vector{other};
  host_.Print(error.what());
  ShowMessage(FirstLine(error.what()));
}

void Viewer::Open(const std::string& file) {
  if (ReferenceImage picture = host_.ReadPicture(file)) {
    pictures_.SetReference(std::move(picture));
    return ShowMessage("the reference is " + file);
  }
  if (!editor_.MayLose(*this, "open another scene")) return;
  try {
    ViewerSettings unedited = settings_;
    unedited.parse.edited.reset();
    auto scene = Load(file, unedited);
    TakeSettings(scene->parsed.scene);
    settings_.scene = file;
    settings_.parse.edited.reset();
    editor_.Forget();
    bookmarks_ = Bookmarks(file);
    pictures_.ForgetTrace();
    flat_.Hide();
    TakeScene(std::move(scene));
    navigator_.SetPivot({});
    navigator_.Go(scene_->parsed.scene.camera);
    ShowMessage("opened " + file + (notes_.empty() ? "" : "; " + notes_));
  } catch (const std::exception& error) {
    TellProblems(file, error);
  }
}

std::optional<R3::Point> Viewer::PointAt(const R2::Point& position) const {
  const R3::Ray ray = navigator_.camera().Through(position.x, position.y, ViewSize().width, ViewSize().height);
  Workspace workspace;
  const auto hit = scene_->accelerator->Intersect(ray, workspace);
  if (!hit) return {};
  return scene_->world.At(ray, *hit).position;
}

Navigator::PointAt Viewer::PointFinder() const {
  return [this](const R2::Point& position) { return PointAt(position); };
}

}  // namespace ray
