#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

#include "source/text/NumberText.h"
#include "source/view/commands/Commands.h"
#include "source/view/panels/Panel.h"

// The overlays of the scene, which keys switch as well.
namespace ray {
namespace {

class DisplayPanel : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    DrawSwitches(frame);
    ImGui::Separator();
    DrawBoxes(frame);
    ImGui::Separator();
    DrawSection(frame);
    ImGui::Separator();
    DrawCamera(frame);
  }

 private:
  using Command = void (*)(ViewerState&);

  static void Switch(PanelFrame& frame, const char* name, bool is_on, const Command& command) {
    if (frame.Check(name, is_on)) frame.Ask(command);
  }
  static void SwitchOf(PanelFrame& frame, const char* name, const char* key, bool SpaceOverlays::*shows) {
    if (frame.Check(std::string(name) + " (" + key + ")", frame.viewer.overlays.*shows))
      frame.Ask([name, shows](ViewerState& v) { Toggle(v, name, shows); });
  }

  static void DrawSwitches(PanelFrame& frame) {
    const ViewerState& viewer = frame.viewer;
    SwitchOf(frame, "faces", "W", &SpaceOverlays::faces);
    SwitchOf(frame, "edges", "E", &SpaceOverlays::edges);
    SwitchOf(frame, "shadows", "Shift+L", &SpaceOverlays::shadows);
    Switch(frame, "lights (L)", viewer.overlays.lights, ToggleLights);
    SwitchOf(frame, "the scene's camera", "Shift+C", &SpaceOverlays::camera);
    SwitchOf(frame, "rendered image in space", "V", &SpaceOverlays::quad);
    Switch(frame, "rays of every 25th pixel (G)", viewer.rays.ShowsGrid(), ToggleGrid);
    Switch(frame, "traced image (Shift+P)", viewer.traced.IsLive(), ToggleTraced);
    Switch(frame, "denoising (M)", viewer.settings.render.denoise, ToggleDenoising);
  }

  static void DrawBoxes(PanelFrame& frame) {
    using Boxes = SpaceOverlays::Boxes;
    const SpaceOverlays& overlays = frame.viewer.overlays;
    frame.Say("bounding boxes (B)");
    for (const auto& [name, boxes] : {std::pair{"no boxes", Boxes::none},
                                      {"boxes of the scene graph", Boxes::nodes},
                                      {"boxes of the accelerator", Boxes::accelerator}})
      if (frame.Word(name, overlays.boxes == boxes))
        frame.Ask([wanted = boxes](ViewerState& v) { ShowBoxes(v, wanted); });
    if (overlays.boxes == Boxes::none) return;
    constexpr int deepest = 24;
    int level = std::min(overlays.box_level, deepest);
    frame.Fact("level", level == all_levels ? "all" : std::to_string(level));
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const bool is_moved = ImGui::SliderInt("##level", &level, all_levels, deepest, "");
    frame.Note("slide level");
    if (is_moved) frame.Ask([level](ViewerState& v) { ChangeBoxLevel(v, level - v.overlays.box_level); });
  }

  static void DrawSection(PanelFrame& frame) {
    const SectionView& section = frame.viewer.section;
    frame.Say("cross section (X)");
    if (frame.Word("no cut", !section.IsShown())) frame.Ask(ToggleSection);
    for (const auto& [name, plane] : {std::pair{"cut along a row of the image", SlicePlane::camera_row},
                                      {"cut along xz", SlicePlane::xz},
                                      {"cut along yz", SlicePlane::yz},
                                      {"cut along xy", SlicePlane::xy}})
      if (frame.Word(name, section.IsShown() && section.Plane() == plane))
        frame.Ask([wanted = plane](ViewerState& v) { ShowSection(v, wanted); });
  }

  static void DrawCamera(PanelFrame& frame) {
    Switch(frame, "level horizon (T)", frame.viewer.navigator.IsTurntable(), ToggleTurntable);
    const double now = frame.viewer.navigator.camera().Fov();
    auto angle = static_cast<float>(now);
    frame.Fact("view angle", Rounded(now, 4) + " degrees");
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const bool is_moved = ImGui::SliderFloat("##angle", &angle, 5, 150, "", ImGuiSliderFlags_AlwaysClamp);
    frame.Note("slide view angle");
    if (!is_moved) return;
    frame.Ask([wanted = static_cast<double>(angle)](ViewerState& v) { Widen(v, wanted / v.navigator.camera().Fov()); });
  }
};

}  // namespace

extern const PanelPart display_part{"display", [] { return std::unique_ptr<Panel>(new DisplayPanel); }};

}  // namespace ray
