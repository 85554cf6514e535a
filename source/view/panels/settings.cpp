#include <imgui.h>

#include <algorithm>
#include <utility>

#include "source/view/commands/Commands.h"
#include "source/view/panels/Panel.h"

// Options of the program, changed while it runs, and the command that renders the view.
namespace ray {
namespace {

/// The longest value that can be typed: as long as names of files.
constexpr std::size_t most_letters = 4096;

void ChangeTo(PanelFrame& frame, const ShownOption& option, const std::string& value) {
  if (value != option.value) frame.Ask([name = option.name, value](ViewerState& v) { ChangeOption(v, name, value); });
}

void DrawChoices(PanelFrame& frame, const ShownOption& option) {
  const std::string label = "##" + option.name;
  const bool is_open = ImGui::BeginCombo(label.c_str(), option.value.c_str());
  frame.Note("-" + option.name);
  if (!is_open) return;
  for (const std::string& choice : option.choices)
    if (frame.Choice(choice, choice == option.value)) ChangeTo(frame, option, choice);
  ImGui::EndCombo();
}

void DrawField(PanelFrame& frame, const ShownOption& option) {
  std::vector<char> text(most_letters);
  option.value.copy(text.data(), text.size() - 1);
  constexpr auto flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll;
  const std::string label = "##" + option.name;
  if (ImGui::InputText(label.c_str(), text.data(), text.size(), flags)) ChangeTo(frame, option, text.data());
  frame.Note("-" + option.name);
}

void DrawOption(PanelFrame& frame, const ShownOption& option) {
  const bool is_switch = option.is_flag || option.choices == std::vector<std::string>{"on", "off"};
  if (is_switch) {
    const bool is_on = option.value == "on";
    if (frame.Check("-" + option.name, is_on)) ChangeTo(frame, option, is_on ? (option.is_flag ? "" : "off") : "on");
  } else {
    constexpr float share_of_value = 0.5F;
    const float all = ImGui::GetContentRegionAvail().x;
    const float name = ImGui::CalcTextSize(("-" + option.name).c_str()).x + ImGui::GetStyle().ItemSpacing.x;
    ImGui::SetNextItemWidth(std::min(share_of_value * all, all - name));
    if (option.choices.empty())
      DrawField(frame, option);
    else
      DrawChoices(frame, option);
    ImGui::SameLine();
    ImGui::TextUnformatted(("-" + option.name).c_str());
  }
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip("%s", (option.help + (option.range.empty() ? "" : "\n" + option.range)).c_str());
}

class SettingsPanel : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const std::string command = frame.viewer.host.CommandFor(frame.viewer.SettingsOfImage());
    if (!command.empty()) {
      frame.Say(command);
      if (frame.viewer.HasMovedCamera()) frame.Say("with the camera moved; key C prints its line");
      if (frame.Button("copy the command"))
        frame.Ask([command](ViewerState& v) { v.host.SetClipboard(command + "\n"); });
    }
    if (!frame.viewer.option_changes.problem.empty()) frame.Say("refused: " + frame.viewer.option_changes.problem);
    std::string topic;
    bool is_open = false;
    for (const ShownOption& option : frame.viewer.host.ShownOptions()) {
      if (std::exchange(topic, option.topic) != option.topic) is_open = DrawTopic(frame, option.topic);
      if (is_open) DrawOption(frame, option);
    }
  }

 private:
  static bool DrawTopic(PanelFrame& frame, const std::string& topic) {
    const bool is_open = ImGui::TreeNodeEx(topic.c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen);
    frame.Note(topic);
    return is_open;
  }
};

}  // namespace

extern const PanelPart settings_part{"settings", [] { return std::unique_ptr<Panel>(new SettingsPanel); }};

}  // namespace ray
