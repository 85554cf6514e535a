#include <imgui.h>

#include <algorithm>

#include "source/view/panels/Panel.h"

// What is wrong with an edited scene.
namespace ray {
namespace {

constexpr ImU32 error_on_dark = IM_COL32(255, 130, 120, 255), error_on_light = IM_COL32(160, 20, 15, 255);

/// The line and a caret below the place, one letter above the other.
void DrawPlace(const SceneError& error, std::size_t number) {
  const std::string margin = std::to_string(error.line) + " | ";
  std::string line = error.source_line;
  std::ranges::replace(line, '\t', ' ');
  const std::size_t before = margin.size() + (error.column > 0 ? error.column - 1 : 0);
  const std::string caret =
      std::string(before, ' ') + "^" + std::string(std::max<std::size_t>(error.length, 1) - 1, '~');
  constexpr int lines = 3;  // both, and the scroll bar of a line that is wider than the panel
  ImGui::BeginChild(static_cast<ImGuiID>(number + 1), {0, lines * ImGui::GetTextLineHeightWithSpacing()}, false,
                    ImGuiWindowFlags_HorizontalScrollbar);
  ImGui::TextUnformatted((margin + line).c_str());
  ImGui::TextUnformatted(caret.c_str());
  ImGui::EndChild();
}

class ErrorsPanel : public Panel {
 public:
  bool IsOfUse(const ViewerState& viewer) const override { return !viewer.scene.Mistakes().empty(); }

  void Draw(PanelFrame& frame) override {
    constexpr std::size_t most = 20;  // as many as a report has in full
    const auto& errors = frame.viewer.scene.Mistakes();
    for (std::size_t i = 0; i < std::min(errors.size(), most); ++i) {
      const SceneError& error = errors[i];
      std::string place = error.file;
      if (error.line > 0) place += ":" + std::to_string(error.line) + ":" + std::to_string(error.column);
      frame.Say(place);
      const bool is_dark = frame.viewer.panels->Look().theme == PanelTheme::dark;
      ImGui::PushStyleColor(ImGuiCol_Text, is_dark ? error_on_dark : error_on_light);
      frame.Say(error.message);
      ImGui::PopStyleColor();
      if (error.line > 0) DrawPlace(error, i);
      if (!error.hint.empty()) frame.Say(error.hint);
      for (const std::string& from : error.included_from) frame.Say("included from " + from);
      ImGui::Separator();
    }
    if (errors.size() > most) frame.Say("and " + std::to_string(errors.size() - most) + " more");
    frame.Say(frame.viewer.scene.ShowsNothing() ? "The scene is shown once the file is right."
                                                : "The scene from before is shown.");
  }
};

}  // namespace

extern const PanelPart errors_part{"errors", [] { return std::unique_ptr<Panel>(new ErrorsPanel); }};

}  // namespace ray
