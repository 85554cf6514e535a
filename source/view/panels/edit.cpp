#include <imgui.h>

#include <array>

#include "source/text/NumberText.h"
#include "source/view/panels/FieldWidgets.h"
#include "source/view/panels/Panel.h"

// What can be changed in the scene: the chosen object, materials, lights, the camera and its lens, the sky.
namespace ray {
namespace {

constexpr std::size_t longest_name = 4096;  // of files, in bytes
constexpr std::size_t most_listed = 50;     // materials, or lights, that a reader goes through

bool Section(PanelFrame& frame, const char* name, bool is_open_at_first = false) {
  const auto flags = ImGuiTreeNodeFlags_NoTreePushOnOpen | (is_open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  const bool is_open = ImGui::TreeNodeEx(name, flags);
  frame.Note(name);
  return is_open;
}

/// Places the next widget, with this label, next to the last one if there is room for it.
void Beside(const char* label) {
  const float square_and_gaps = ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().FramePadding.x;  // of a check box
  ImGui::SameLine();
  if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize(label).x + square_and_gaps) ImGui::NewLine();
}

class EditPanel : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const std::string why = frame.viewer.editor.WhyNot();
    if (!why.empty()) return frame.Say(why);
    DrawHistory(frame);
    if (Section(frame, "Object", true)) DrawPart(frame, "object", [&] { DrawObject(frame); });
    if (Section(frame, "Material")) DrawPart(frame, "material", [&] { DrawMaterials(frame); });
    if (Section(frame, "Lights")) DrawPart(frame, "lights", [&] { DrawLights(frame); });
    if (Section(frame, "Camera and lens")) DrawPart(frame, "camera", [&] { DrawCamera(frame); });
    if (Section(frame, "Sky")) DrawPart(frame, "sky", [&] { DrawSky(frame); });
  }

 private:
  template <typename Part>
  static void DrawPart(PanelFrame&, const char* name, const Part& part) {
    ImGui::PushID(name);
    part();
    ImGui::PopID();
  }

  static void Command(PanelFrame& frame, const char* name, void (SceneEditor::*act)()) {
    if (frame.Button(name)) frame.Ask([act](ViewerState& v) { (v.editor.*act)(); });
  }

  static void DrawHistory(PanelFrame& frame) {
    const SceneEditor& editor = frame.viewer.editor;
    Command(frame, "undo", &SceneEditor::Undo);
    Beside("redo");
    Command(frame, "redo", &SceneEditor::Redo);
    Beside("save");
    Command(frame, "save", &SceneEditor::Save);
    Beside("save a copy");
    Command(frame, "save a copy", &SceneEditor::SaveCopy);
    frame.Fact("changes", editor.Describe());
    if (const Change* last = editor.History().ToUndo()) frame.Fact("last", last->what);
  }

  void DrawObject(PanelFrame& frame) {
    const ViewerState& viewer = frame.viewer;
    const auto statement = viewer.editor.ChosenStatement();
    if (viewer.editor.ChosenLight()) return frame.Say("a light is chosen");
    if (!viewer.selection.node) return frame.Say("click an object to choose it");
    if (!statement) return frame.Say("it stands in no scene file");
    frame.Say(NameOf(viewer.scene.Loaded().places, *statement));
    object_fields_.Draw(frame, *statement);
    DrawMoves(frame);
  }

  static void DrawMoves(PanelFrame& frame) {
    Command(frame, "duplicate", &SceneEditor::Duplicate);
    Beside("delete");
    Command(frame, "delete", &SceneEditor::Delete);
    Beside("- move");
    if (frame.Button("- move")) frame.Ask([](ViewerState& v) { v.editor.MoveBySteps(-1); });
    Beside("+ move");
    if (frame.Button("+ move")) frame.Ask([](ViewerState& v) { v.editor.MoveBySteps(1); });
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("along");
    constexpr std::pair<const char*, MoveAxis> axes[] = {
        {"x", MoveAxis::x}, {"y", MoveAxis::y}, {"z", MoveAxis::z}, {"plane of view", MoveAxis::view}};
    for (const auto& [name, axis] : axes) {
      Beside(name);
      if (frame.Word(name, frame.viewer.editor.Axis() == axis))
        frame.Ask([axis = axis](ViewerState& v) { v.editor.SetAxis(axis); });
    }
  }

  void DrawMaterials(PanelFrame& frame) {
    const ViewerState& viewer = frame.viewer;
    const ScnPlaces& places = viewer.scene.Loaded().places;
    const auto chosen = viewer.editor.ChosenMaterial();
    std::size_t listed = 0;
    for (std::size_t i = 0; i < places.materials.size() && listed < most_listed; ++i) {
      if (places.materials[i] == ScnPlaces::nowhere) continue;
      ++listed;
      ImGui::PushID(static_cast<int>(i));
      const R2::Color& kd = viewer.scene.Parsed().materials[i].kd;
      const std::string comment = CommentOf(places, places.materials[i]);
      const std::string name = NameOf(places, places.materials[i]) + (comment.empty() ? "" : ": " + comment);
      const bool by_swatch = DrawSwatch(frame, "swatch of " + name, {kd.r, kd.g, kd.b});
      ImGui::SameLine();
      if (frame.Choice(name, chosen == i) || by_swatch) frame.Ask([i](ViewerState& v) { v.editor.ChooseMaterial(i); });
      ImGui::PopID();
    }
    if (listed == 0) return frame.Say("the scene file has no material");
    if (listed == most_listed) frame.Say("click an object to choose its material");
    if (!chosen) return;
    if (*chosen >= places.materials.size() || places.materials[*chosen] == ScnPlaces::nowhere)
      return frame.Say("the chosen object's material stands in no scene file");
    ImGui::Separator();
    material_fields_.Draw(frame, places.materials[*chosen]);
    DrawTexture(frame, *chosen);
    DrawMore(frame, *chosen, "mirror", mirror_fields_);
    DrawMore(frame, *chosen, "gloss", gloss_fields_);
  }

  static void DrawTexture(PanelFrame& frame, std::size_t material) {
    std::array<char, longest_name> text{};
    TextureOf(frame.viewer.scene.Loaded().places, material).copy(text.data(), text.size() - 1);
    constexpr const char* label = "texture";
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(label).x -
                            ImGui::GetStyle().ItemInnerSpacing.x);
    constexpr auto flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;
    const bool is_entered = ImGui::InputText(label, text.data(), text.size(), flags);
    frame.Note(label);
    if (is_entered)
      frame.Ask([material, name = std::string(text.data())](ViewerState& v) { v.editor.SetTexture(material, name); });
  }

  /// Draws the fields of a separate statement about a material, or a button that adds one.
  static void DrawMore(PanelFrame& frame, std::size_t material, const std::string& command, FieldWidgets& fields) {
    ImGui::PushID(command.c_str());
    if (const auto about = AboutMaterial(frame.viewer.scene.Loaded().places, material, command))
      fields.Draw(frame, *about);
    else if (frame.Button("add " + command))
      frame.Ask([material, command](ViewerState& v) { v.editor.AddToMaterial(material, command); });
    ImGui::PopID();
  }

  void DrawLights(PanelFrame& frame) {
    const ViewerState& viewer = frame.viewer;
    const ScnPlaces& places = viewer.scene.Loaded().places;
    const auto chosen = viewer.editor.ChosenLight();
    if (places.lights.empty()) frame.Say("the scene file has no light; these are the default ones");
    for (std::size_t i = 0; i < std::min(places.lights.size(), most_listed); ++i) {
      ImGui::PushID(static_cast<int>(i));
      if (frame.Choice(NameOf(places, places.lights[i]), chosen == i))
        frame.Ask([i](ViewerState& v) { v.editor.ChooseLight(i); });
      ImGui::PopID();
    }
    if (!chosen || *chosen >= places.lights.size()) return;
    ImGui::Separator();
    light_fields_.Draw(frame, places.lights[*chosen]);
    DrawMoves(frame);
  }

  void DrawCamera(PanelFrame& frame) {
    const ViewerState& viewer = frame.viewer;
    if (const auto camera = LastOf(viewer.scene.Loaded().places, "camera"))
      camera_fields_.Draw(frame, *camera);
    else
      frame.Say("the scene file has no camera");
    Command(frame, "view as scene camera", &SceneEditor::KeepCamera);
    const CameraEffects lens = viewer.SettingsOfView().camera;
    const double distance = Length(viewer.navigator.Center() - viewer.navigator.camera().eye);
    const auto set = [&frame](const char* option) {
      return [&frame, option](double value, bool continues) {
        frame.Ask(
            [option, value, continues](ViewerState& v) { v.editor.SetSetting(option, ToText(value), continues); });
      };
    };
    constexpr double widest = 0.1, nearest = 0.05, farthest = 5;  // of the distance to the middle
    FieldWidgets::DrawNumber(frame, "aperture", lens.aperture, {0, widest * distance}, set("aperture"));
    FieldWidgets::DrawNumber(frame, "focus", lens.focus, {nearest * distance, farthest * distance}, set("focus"));
    frame.Say("K focuses on what is under the pointer");
  }

  void DrawSky(PanelFrame& frame) {
    const auto draw = [&](const char* command, FieldWidgets& fields) {
      const auto statement = LastOf(frame.viewer.scene.Loaded().places, command);
      if (!statement) return;
      ImGui::PushID(command);
      frame.Say(command);
      fields.Draw(frame, *statement);
      ImGui::PopID();
    };
    draw("background", background_fields_);
    draw("ambient", ambient_fields_);
  }

  FieldWidgets object_fields_, material_fields_, mirror_fields_, gloss_fields_, light_fields_, camera_fields_,
      background_fields_, ambient_fields_;
};

}  // namespace

extern const PanelPart edit_part{"edit", [] { return std::unique_ptr<Panel>(new EditPanel); }};

}  // namespace ray
