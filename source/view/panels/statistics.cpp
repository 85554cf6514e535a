#include <imgui.h>

#include "source/text/EnumNames.h"
#include "source/text/NumberText.h"
#include "source/text/Words.h"
#include "source/view/live/JobStatus.h"
#include "source/view/panels/Panel.h"

// How the image that is rendered is getting on, and what its rays cost.
namespace ray {
namespace {

void DrawRays(PanelFrame& frame, const RayCounts& rays) {
  if (!ImGui::BeginTable("rays", 4, ImGuiTableFlags_SizingFixedFit)) return;
  for (const char* title : {"rays of", "number", "boxes", "tests"}) ImGui::TableSetupColumn(title);
  ImGui::TableHeadersRow();
  const auto row = [](const std::string& name, std::uint64_t count, const Counts& cost) {
    if (count == 0) return;
    const auto per_ray = [&](std::uint64_t number) {
      return Rounded(static_cast<double>(number) / static_cast<double>(count), 3);
    };
    for (const std::string& cell :
         {name, std::to_string(count), per_ray(cost.box_tests + cost.node_visits), per_ray(cost.primitive_tests)}) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(cell.c_str());
    }
  };
  for (std::size_t kind = 0; kind < rays.kinds.size(); ++kind)
    row(ray_kind_names[kind], rays.kinds[kind].rays, rays.kinds[kind].cost);
  row("all", rays.Total(), rays.Cost());
  ImGui::EndTable();
  if (rays.cut > 0) frame.Fact("cut", Counted(rays.cut, "ray"));
}

class StatisticsPanel : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const World& world = frame.viewer.scene.world();
    frame.Fact("scene", Counted(static_cast<std::uint64_t>(world.Primitives()), "primitive") + ", " +
                            Counted(world.Instances().size(), "instance") + ", " +
                            Counted(world.Nodes().size(), "node"));
    const RenderJob* job = frame.viewer.traced.Job();
    if (!job) return frame.Say("Nothing is rendered yet; P renders live, S an image.");
    frame.Fact("mode", NameOf(job->Settings().mode));
    frame.Fact("samples", std::to_string(job->Samples()) + " of " + std::to_string(job->Settings().samples));
    const double seconds = job->Seconds();
    frame.Fact("seconds", Brief(seconds));
    constexpr double million = 1e6;
    if (seconds > 0) frame.Fact("Mrays/s", Brief(static_cast<double>(job->Rays()) / million / seconds));
    if (!job->HasEnded()) return frame.Fact("state", "rendering");
    const RenderResult* result = job->Result();
    frame.Fact("state", result ? "complete" : "stopped");
    if (!result) return;
    if (result->error) frame.Say(ClaimOf(*result));
    DrawRays(frame, result->rays);
  }
};

}  // namespace

extern const PanelPart statistics_part{"statistics", [] { return std::unique_ptr<Panel>(new StatisticsPanel); }};

}  // namespace ray
