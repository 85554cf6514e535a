#include <imgui.h>

#include <cmath>
#include <utility>

#include "source/text/NumberText.h"
#include "source/view/live/AcceleratorCost.h"
#include "source/view/panels/Panel.h"

// The accelerator in force, and what it and the others cost in this view.
namespace ray {
namespace {

std::string Digits(double number) { return Rounded(number, 3); }

/// To the microsecond, below which clocks tell little.
std::string Milliseconds(double seconds) {
  constexpr double micro = 1e6, in_milli = 1e3;
  return Digits(std::round(seconds * micro) / in_milli);
}

class AcceleratorsPanel : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const Accelerator& accelerator = *frame.viewer.scene().accelerator;
    frame.Fact("built", accelerator.kind);
    for (const std::string& reason : accelerator.reasons) frame.Say(reason);
    for (const std::string& line : accelerator.Explain()) frame.Say(line);
    if (std::exchange(scene_number_, frame.viewer.SceneNumber()) != frame.viewer.SceneNumber()) costs_.clear();
    // Done between frames, as it takes its time.
    if (frame.Button("compare all")) frame.Ask([this](Viewer& v) { costs_ = v.CostsOfAccelerators(); });
    if (!costs_.empty()) DrawCosts(frame, accelerator.kind);
  }

 private:
  void DrawCosts(PanelFrame& frame, const std::string& in_force) {
    constexpr const char* titles[] = {"", "build", "draw", "box", "test", "kB"};
    if (!ImGui::BeginTable("costs", std::size(titles), ImGuiTableFlags_SizingFixedFit)) return;
    for (const char* title : titles) ImGui::TableSetupColumn(title);
    ImGui::TableHeadersRow();
    constexpr double kilo = 1e3;
    for (const AcceleratorCost& cost : costs_) {
      ImGui::TableNextColumn();
      if (frame.Choice(cost.name, cost.name == in_force))
        frame.Ask([name = cost.name](Viewer& v) { v.ChangeOption("accel", name); });
      for (const std::string& cell :
           {Milliseconds(cost.build_seconds), Milliseconds(cost.render_seconds), Digits(cost.boxes), Digits(cost.tests),
            Digits(static_cast<double>(cost.bytes) / kilo)}) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(cell.c_str());
      }
    }
    ImGui::EndTable();
    frame.Say(
        "ms to build, and to draw a small picture of this view; boxes and primitives tested per ray. A click takes "
        "one; the image stays the same.");
  }

  int scene_number_ = 0;
  std::vector<AcceleratorCost> costs_;  // empty until they are asked for
};

}  // namespace

extern const PanelKind accelerators_panel{"Accelerators", false,
                                          [] { return std::unique_ptr<Panel>(new AcceleratorsPanel); }};

}  // namespace ray
