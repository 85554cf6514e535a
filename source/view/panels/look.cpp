#include <imgui.h>

#include "source/view/commands/Commands.h"
#include "source/view/panels/Panel.h"

// Colors and letters of the panels themselves.
namespace ray {
namespace {

class LookPanel : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const PanelSettings now = frame.viewer.panels->Look();
    const auto ask = [&](const PanelSettings& look) { frame.Ask([look](ViewerState& v) { SetPanelLook(v, look); }); };
    for (const auto& [name, theme] :
         {std::pair{"dark theme", PanelTheme::dark}, std::pair{"light theme", PanelTheme::light}}) {
      if (frame.Word(name, now.theme == theme)) ask({theme, now.letters, now.width});
      if (theme == PanelTheme::dark) ImGui::SameLine();
    }
    constexpr double step = 1.25;
    if (frame.Button("smaller")) ask({now.theme, now.letters / step, now.width});
    ImGui::SameLine();
    if (frame.Button("larger")) ask({now.theme, now.letters * step, now.width});
  }
};

}  // namespace

extern const PanelPart look_part{"look", [] { return std::unique_ptr<Panel>(new LookPanel); }};

}  // namespace ray
