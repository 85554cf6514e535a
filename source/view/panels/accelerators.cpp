#include <imgui.h>

#include <cmath>
#include <vector>

#include "source/text/NumberText.h"
#include "source/view/commands/Commands.h"
#include "source/view/live/AcceleratorCost.h"
#include "source/view/panels/Panel.h"

// The accelerator in force, and what it and the others cost in this view.
namespace ray {
namespace {

std::string Digits(double number) { return Plain(number, 3); }

/// Rounds to microseconds, below which clocks are unreliable.
std::string Milliseconds(double seconds) {
  constexpr double micro = 1e6, in_milli = 1e3;
  return Digits(std::round(seconds * micro) / in_milli);
}

class AcceleratorsPanel : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const Accelerator& accelerator = *frame.viewer.scene.Loaded().accelerator;
    frame.Fact("built", accelerator.kind);
    for (const std::string& reason : accelerator.reasons) frame.Say(reason);
    for (const std::string& line : accelerator.Explain()) frame.Say(line);
    const AcceleratorComparison* found = frame.viewer.accelerators.Current();
    if (found && !found->HasEnded()) {
      frame.Say("building and trying " + found->Current());
      if (frame.Button("stop")) frame.Ask([](ViewerState& v) { StopComparingAccelerators(v); });
    } else if (frame.Button("compare all")) {
      frame.Ask([](ViewerState& v) { CompareAccelerators(v); });
    }
    if (found && !found->Costs().empty()) DrawCosts(frame, found->Costs(), accelerator.kind);
  }

 private:
  static void DrawCosts(PanelFrame& frame, const std::vector<AcceleratorCost>& costs, const std::string& in_force) {
    constexpr const char* titles[] = {"", "build", "draw", "box", "test", "kB"};
    if (!ImGui::BeginTable("costs", std::size(titles), ImGuiTableFlags_SizingFixedFit)) return;
    for (const char* title : titles) ImGui::TableSetupColumn(title);
    ImGui::TableHeadersRow();
    constexpr double kilo = 1e3;
    for (const AcceleratorCost& cost : costs) {
      ImGui::TableNextColumn();
      if (frame.Choice(cost.name, cost.name == in_force))
        frame.Ask([name = cost.name](ViewerState& v) { ChangeOption(v, "accel", name); });
      for (const std::string& cell :
           {Milliseconds(cost.build_seconds), Milliseconds(cost.render_seconds), Digits(cost.boxes), Digits(cost.tests),
            Digits(static_cast<double>(cost.bytes) / kilo)}) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(cell.c_str());
      }
    }
    ImGui::EndTable();
    frame.Say(
        "ms to build, and to draw a small image of this view; boxes and primitives tested per ray. A click takes "
        "one; the image stays the same.");
  }
};

}  // namespace

extern const PanelPart accelerators_part{"accelerators", [] { return std::unique_ptr<Panel>(new AcceleratorsPanel); }};

}  // namespace ray
