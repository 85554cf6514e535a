#include <imgui.h>

#include <algorithm>
#include <array>

#include "source/text/LowerCase.h"
#include "source/view/panels/Panel.h"

// What mouse and keys do, to be searched.
namespace ray {
namespace {

class HelpPanel : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    ImGui::InputTextWithHint("##search", "search", search_.data(), search_.size());
    frame.Note("search");
    const std::string searched = LowerCase(search_.data());
    const HelpRow* heading = nullptr;
    for (const HelpRow& row : rows_) {
      if (row.keys.empty()) {
        heading = &row;
        continue;
      }
      if (LowerCase(row.keys + " " + row.text).find(searched) == std::string::npos) continue;
      if (heading) frame.Say(heading->text);
      heading = nullptr;
      DrawRow(frame, row);
    }
  }

 private:
  static void DrawRow(PanelFrame& frame, const HelpRow& row) {
    constexpr std::size_t short_keys = 8;  // letters that leave room beside them
    if (row.keys.size() <= short_keys) return frame.Fact(row.keys, row.text);
    ImGui::TextDisabled("%s", row.keys.c_str());
    ImGui::Indent();
    frame.Say(row.text);
    ImGui::Unindent();
  }

  const std::vector<HelpRow> rows_ = Viewer::HelpRows();
  std::array<char, 64> search_{};  // longer than any word of the help
};

}  // namespace

extern const PanelKind help_panel{"Help", false, [] { return std::unique_ptr<Panel>(new HelpPanel); }};

}  // namespace ray
