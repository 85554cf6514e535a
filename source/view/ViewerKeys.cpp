#include <algorithm>
#include <cmath>
#include <numbers>

#include "R1/Elementary.h"
#include "source/scene/CameraText.h"
#include "source/text/EnumNames.h"
#include "source/text/NumberText.h"
#include "source/text/Words.h"
#include "source/view/Viewer.h"
#include "source/view/overlay/SceneLines.h"

/// What keys do, where it is more than a line of the table.
namespace ray {

void Viewer::StartTrace() {
  const TracedAs as{scene_number_, options_number_, CameraLine(navigator_.camera()), size_};
  const bool continues = pictures_.CanContinue() && as == traced_as_;
  traced_as_ = as;
  if (continues)
    pictures_.ContinueTrace(scene_, SettingsOfView());
  else
    pictures_.StartTrace(scene_, SettingsOfView());
  pictures_.HideLive();
  shows_quad_ = true;
  ShowMessage(continues ? "rendering continues where it was stopped" : "rendering");
  InvalidateLines();
}

void Viewer::Peel() {
  if (shows_help_) return ToggleHelp();
  if (flat_.IsShown()) return ToggleFlat();
  if (pick_) {
    pick_.reset();
    ChooseNode({});
    return ShowMessage("pick forgotten");
  }
  if (section_.IsShown()) return ToggleSection();
  if (!scene_problems_.empty() && problem_file_ != settings_.scene) {
    scene_problems_.clear();
    return ShowMessage("mistakes of " + problem_file_ + " forgotten");
  }
  ShowMessage(pictures_.StopTrace() || pictures_.StopLive() ? "rendering is being stopped"
                                                            : "nothing to close; Q quits");
}

void Viewer::Quit() {
  if (!editor_.MayLose(*this, "quit")) return;
  if (!pictures_.IsTracing() || was_asked_to_quit_) {
    is_closed_ = true;
    return;
  }
  was_asked_to_quit_ = true;
  ShowMessage("still rendering; Q, or closing the window, once more quits without saving");
}

void Viewer::ToggleLights() {
  shows_lights_ = !shows_lights_;
  InvalidateLines();
  if (!shows_lights_) return ShowMessage("lights off");
  int lights = 0, in_view = 0, far = 0;
  const DrawingSize view = ViewSize();
  for (const auto& light : scene_->parsed.scene.lights) {
    if (light->IsBlack()) continue;
    ++lights;
    if (light->Bound().is_infinite) {
      ++far;
      continue;
    }
    const auto pixel = PixelOf(navigator_.camera(), light->Bound().center, view);
    in_view += pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x < view.width && pixel->y < view.height;
  }
  const int outside = lights - far - in_view;
  ShowMessage(std::to_string(lights) + (lights == 1 ? " light" : " lights") +
              (outside > 0 ? ", " + std::to_string(outside) + " out of view; F frames them" : ""));
}

void Viewer::PrintCamera() {
  const std::string line = CameraLine(navigator_.camera());
  host_.Print(line);
  host_.SetClipboard(line + "\n");
  ShowMessage("camera printed and copied to the clipboard");
}

void Viewer::CycleBoxes() {
  boxes_ = boxes_ == Boxes::none ? Boxes::nodes : boxes_ == Boxes::nodes ? Boxes::accelerator : Boxes::none;
  InvalidateLines();
  ShowMessage(BoxesInWords());
}

void Viewer::ChangeBoxLevel(int by) {
  if (boxes_ == Boxes::none) boxes_ = Boxes::nodes;
  constexpr int deepest = 1 << 20;
  box_level_ = std::clamp(box_level_ + by, all_levels, deepest);
  InvalidateLines();
  ShowMessage(BoxesInWords());
}

void Viewer::FrameScene() {
  const R3::Box box = BoxToFrame();
  if (box.IsEmpty()) return ShowMessage("the scene is empty and cannot be framed");
  navigator_.Frame(box);
  ShowMessage(shows_lights_ ? "the whole scene and its lights are framed" : "the whole scene is framed");
}

std::string Viewer::AngleInWords() const {
  constexpr double degrees = 180 / std::numbers::pi;
  return Fixed(2 * degrees * R1::Atan(navigator_.camera().HalfWidth()), 1) + " degrees across";
}

void Viewer::FramePicked() {
  if (!pick_ || !pick_->point) return ShowMessage("nothing is picked; click an object first");
  const Instance& instance = scene_->world.Instances()[pick_->instance];
  if (!instance.is_bounded) return ShowMessage("it is infinite and cannot be framed");
  const R3::Box box = scene_->world.InWorld(instance.frame, R3::Bounds(*instance.shape));
  navigator_.SetPivot(pick_->point);
  navigator_.Frame(box);
  ShowMessage("the picked object is framed");
}

void Viewer::KeepBookmark(int digit) {
  bookmarks_.ReadAgain();
  bookmarks_.Set(digit, navigator_.camera());
  const std::string problem = bookmarks_.File().empty() ? "the scene is no file for them to be kept beside"
                                                        : host_.SaveText(bookmarks_.File(), bookmarks_.Text());
  ShowMessage("bookmark " + std::to_string(digit) +
              (problem.empty() ? " saved" : " lasts for this session only: " + problem));
}

void Viewer::RecallBookmark(int digit) {
  const auto camera = bookmarks_.Find(digit);
  const std::string name = "bookmark " + std::to_string(digit);
  if (!camera)
    return ShowMessage("there is no " + name + "; Control+" + std::to_string(digit) + " saves this view as it");
  navigator_.Go(*camera);
  ShowMessage("at " + name);
}

void Viewer::ToggleGrid() {
  InvalidateLines();
  if (rays_.ShowsGrid()) {
    rays_.ToggleGrid();
    return ShowMessage("rays off");
  }
  rays_.TraceGrid(*scene_, pictures_.Trace() ? pictures_.Trace()->Settings() : SettingsOfView());
  ShowMessage("rays of " + Counted(rays_.Grid().size(), "pixel") + "; F2 to F5 choose kinds, N bounces");
}

void Viewer::DebugPixelAt(const R2::Point& position) {
  if (const auto pixel = FlatJob() ? std::nullopt : PixelOnQuad(position)) {
    rays_.TracePixel(*scene_, pictures_.Trace()->Settings(), pixel->first, pixel->second);
  } else {
    const R2::Point p = InPicture(position);
    const RenderSettings settings = SettingsOfPicture();
    if (p.x < 0 || p.y < 0 || p.x >= settings.width || p.y >= settings.height) return;
    rays_.TracePixel(*scene_, settings, static_cast<int>(p.x), static_cast<int>(p.y));
  }
  ReportPixel();
}

void Viewer::ReportPixel() {
  arrows_move_section_ = false;
  const PixelTrace& pixel = *rays_.Pixel();
  host_.Print(RayTree(pixel, scene_->world, rays_.PixelSettings()));
  ShowMessage("pixel " + std::to_string(pixel.column) + " " + std::to_string(pixel.row) + ", " +
              Counted(pixel.rays.size(), "ray") + rays_.WhatIsLeftOut());
  InvalidateLines();
}

void Viewer::MoveByArrow(int right, int up) {
  if (arrows_move_section_) {
    MoveSection(up);
  } else if (rays_.StepPixel(*scene_, right, up)) {
    ReportPixel();
  } else {
    ShowMessage(rays_.Pixel() ? "the border of the picture" : "right-click a pixel first, or press X");
  }
}

void Viewer::SaveRays() {
  const auto shown = rays_.Shown();
  if (shown.empty()) return ShowMessage("no rays are shown; press G or right-click a pixel first");
  ShowMessage(host_.SaveRays(RaysAsObj(shown, space_.radius)));
}

void Viewer::ToggleLive(std::optional<RenderMode> mode) {
  if (pictures_.IsLive() && pictures_.LiveMode() == mode)
    pictures_.HideLive();
  else
    pictures_.ShowLive(mode);
  InvalidateLines();
  const std::string what = NameOf(mode.value_or(settings_.render.mode));
  if (!pictures_.IsLive()) return ShowMessage("live rendering off");
  pictures_.Update(scene_, SettingsOfView(), settings_.live_is_endless);
  const bool is_endless = pictures_.Live()->Settings().budget.is_endless;
  ShowMessage("live rendering, mode " + what + (is_endless ? ", until stopped" : ""));
}

void Viewer::KeepReference() {
  const auto current = pictures_.Current();
  if (!current) return ShowMessage("nothing is rendered yet; press S or P first");
  pictures_.SetReference({current});
  ShowMessage("image kept as the reference");
}

void Viewer::Compare(TracedPictures::Comparing how) {
  pictures_.Compare(pictures_.HowCompared() == how ? TracedPictures::Comparing::no : how);
  ShowMessage(pictures_.HowCompared() == TracedPictures::Comparing::no ? "comparing off" : pictures_.Comparison());
}

void Viewer::ChangeExposure(double steps) { SetExposure(steps == 0 ? 0 : exposure_steps_ + steps); }

void Viewer::ToggleHelp() {
  shows_help_ = !shows_help_;
  TellPanelsTheirParts();
  ShowMessage(shows_help_ ? "help; type to search it, Escape closes it" : "help closed");
}

}  // namespace ray
