#include <array>
#include <stdexcept>

#include "source/text/Words.h"
#include "source/view/Viewer.h"
#include "source/view/overlay/SceneLines.h"

/// What panels ask a viewer for.
namespace ray {

ViewerSettings ViewerHost::ChangeOption(const std::string& name, const std::string&) {
  throw std::invalid_argument("there is no option " + name);
}

void Viewer::ChangeOption(const std::string& name, const std::string& value) {
  // What is saved at its end is to be the picture of one command.
  if (pictures_.IsUnsaved()) {
    option_problem_ = "an image is being rendered; Escape stops it";
    return ShowMessage(option_problem_);
  }
  ViewerSettings changed;
  try {
    changed = host_.ChangeOption(name, value);
  } catch (const std::exception& error) {
    option_problem_ = error.what();
    return ShowMessage(option_problem_);
  }
  option_problem_.clear();
  changed.parse.edited = settings_.parse.edited;
  ++options_number_;
  const bool is_read_again = changed.parse != settings_.parse || changed.accelerator != settings_.accelerator;
  settings_.parse = changed.parse;
  settings_.accelerator = changed.accelerator;
  settings_.render = changed.render;
  settings_.live_is_endless = changed.live_is_endless;
  if (is_read_again) return Reload();
  MakeFaces();
  pictures_.Touch();
  InvalidateLines();
  ShowMessage("-" + name + " " + value);
}

void Viewer::ShowPanels(const PanelSettings& look) {
  panels_->SetLook(look);
  shows_panels_ = true;
  TellPanelsTheirParts();
  section_drawing_.reset();
  InvalidateLines();
}

void Viewer::TogglePanels() {
  if (shows_panels_) {
    shows_panels_ = false;
    TellPanelsTheirParts();
    InvalidateLines();
    return ShowMessage("panels off");
  }
  ShowPanels(PanelLook());
  ShowMessage("panels; Tab hides them");
}

const std::vector<PanelItem>& Viewer::ItemsOfPanels() const {
  static const std::vector<PanelItem> none;
  return shows_panels_ || shows_help_ ? panels_->Items() : none;
}

void Viewer::SetPanelLook(const PanelSettings& look) {
  panels_->SetLook(look);
  section_drawing_.reset();
  needs_redraw_ = true;
}

void Viewer::ChooseNode(std::optional<std::size_t> node) {
  chosen_node_ = node;
  InvalidateLines();
}

void Viewer::ChooseRay(std::optional<std::size_t> ray) {
  if (!rays_.Pixel()) return;
  rays_.Choose(ray);
  InvalidateLines();
}

void Viewer::ToggleRays(ShownRays kind) {
  constexpr std::array names{"camera rays", "shadow rays", "reflected and scattered rays", "transmitted rays"};
  static_assert(names.size() == shown_ray_kinds);
  const auto i = static_cast<std::size_t>(kind);
  rays_.Toggle(kind);
  section_drawing_.reset();
  InvalidateLines();
  ShowMessage(std::string(names[i]) + (rays_.Look().shows[i] ? " on" : " off"));
}

void Viewer::ToggleNormals() {
  rays_.ToggleNormals();
  InvalidateLines();
  ShowMessage(std::string("normals at hit points") + (rays_.Look().normals ? " on" : " off"));
}

void Viewer::SetDebugRays(const DebugRayCounts& counts) {
  rays_.SetCounts(counts);
  if (rays_.ShowsGrid()) rays_.TraceGrid(*scene_, pictures_.Trace() ? pictures_.Trace()->Settings() : SettingsOfView());
  rays_.TraceAgain(*scene_);
  section_drawing_.reset();
  InvalidateLines();
  ShowMessage(Counted(static_cast<std::uint64_t>(counts.camera), "camera ray") + " per pixel, " +
              Counted(static_cast<std::uint64_t>(counts.shadow), "shadow ray") + " per light; cut: 1 of " +
              Counted(static_cast<std::uint64_t>(counts.spacing), "pixel"));
}

void Viewer::ShowLayer(std::optional<RenderMode> mode) {
  if (mode ? !pictures_.IsLive() || pictures_.LiveMode() != mode : pictures_.IsLive())
    ToggleLive(mode ? mode : pictures_.LiveMode());
}

void Viewer::CompareAccelerators() {
  accelerators_ = std::make_unique<AcceleratorComparison>(scene_, settings_.accelerator, SettingsOfView());
  accelerators_seen_ = 0;
  ShowMessage("comparing accelerators");
}

void Viewer::StopComparingAccelerators() {
  if (accelerators_) accelerators_->Stop();
  ShowMessage("comparing stops after the accelerator that is being built");
}

void Viewer::FrameChosenNode() {
  if (!chosen_node_) return;
  const World& world = scene_->world;
  const R3::Box box = world.InWorld(FrameAround(world, *chosen_node_), world.Nodes()[*chosen_node_].node->bounds);
  if (box.IsEmpty()) return ShowMessage("it is infinite or empty and cannot be framed");
  navigator_.Frame(box);
}

}  // namespace ray
