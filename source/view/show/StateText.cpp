#include "source/view/show/Show.h"

#include <filesystem>

#include "source/scene/CameraText.h"
#include "source/text/EnumNames.h"
#include "source/text/NumberText.h"
#include "source/view/commands/Commands.h"

namespace ray {

std::string TextOfPanels(ViewerState& viewer) {
  const PanelParts parts = viewer.Parts();
  return parts.column || parts.help || parts.bar ? viewer.panels->Text(viewer) : std::string();
}

std::string TitleOf(const ViewerState& viewer) {
  const std::string name = std::filesystem::path(viewer.settings.scene).filename().string();
  return name + (viewer.editor.HasUnsaved() ? "* " : " ") + std::to_string(viewer.screen.size.width) + "x" +
         std::to_string(viewer.screen.size.height) +
         (viewer.scene.Mistakes().empty() ? "" : " (mistakes in " + viewer.scene.MistakenFile() + ")") +
         (viewer.status.Text().empty() ? "" : " " + viewer.status.Text());
}

std::string DescribeState(ViewerState& viewer) {
  std::string text;
  const auto line = [&](const std::string& name, const std::string& value) { text += name + " " + value + "\n"; };
  const auto yes_or_no = [](bool is) { return is ? "yes" : "no"; };
  line("scene", viewer.settings.scene);
  line("size", std::to_string(viewer.screen.size.width) + " " + std::to_string(viewer.screen.size.height));
  text += CameraLine(viewer.navigator.camera()) + "\n";
  line("faces", yes_or_no(viewer.overlays.faces));
  line("edges", yes_or_no(viewer.overlays.edges));
  line("lights", yes_or_no(viewer.overlays.lights));
  line("shadows", yes_or_no(viewer.overlays.shadows));
  line("frustum", yes_or_no(viewer.overlays.camera));
  line("quad", yes_or_no(viewer.Quad().has_value()));
  line("boxes",
       DescribeBoxes(viewer.overlays, viewer.scene.world(), *viewer.scene.Loaded().accelerator, viewer.scene.Space()));
  line("turntable", yes_or_no(viewer.navigator.IsTurntable()));
  line("pivot", yes_or_no(viewer.navigator.Pivot().has_value()));
  line("live", viewer.traced.IsLive() ? NameOf(viewer.traced.LiveMode().value_or(viewer.settings.render.mode)) : "no");
  line("status", viewer.status.Text());
  line("trace", !viewer.traced.Trace()                ? "none"
                : viewer.traced.IsTracing()           ? "running"
                : viewer.traced.Trace()->IsComplete() ? "complete"
                                                      : "stopped");
  line("flat", viewer.flat.IsShown()
                   ? "zoom " + Rounded(viewer.flat.ZoomFactor(), 4) + " slider " + Rounded(viewer.flat.Slider(), 4)
                   : "no");
  line("grid", std::to_string(viewer.rays.ShowsGrid() ? viewer.rays.Grid().size() : 0));
  line("pixel", viewer.rays.Pixel()
                    ? std::to_string(viewer.rays.Pixel()->column) + " " + std::to_string(viewer.rays.Pixel()->row)
                    : "none");
  const RayLook& look = viewer.rays.Look();
  std::string kinds;
  for (const bool shows : look.shows) kinds += shows ? '1' : '0';
  line("rays", kinds + (look.normals ? "1" : "0") + " deepest " + std::to_string(look.deepest));
  if (const std::string place = TextOfSection(viewer); !place.empty()) line("under the pointer", place);
  line("cut", viewer.section.IsShown() ? viewer.section.Describe(viewer.screen.size.height) : "no");
  line("exposure", ToText(viewer.exposure_steps));
  line("comparing", std::to_string(static_cast<int>(viewer.traced.HowCompared())));
  line("reference", yes_or_no(viewer.traced.Reference() != nullptr));
  line("help", yes_or_no(viewer.shows.help));
  line("problem", TextOfProblems(viewer));
  line("message", viewer.notices.Message());
  line("edits", viewer.editor.Describe());
  line("panels", yes_or_no(viewer.shows.panels));
  return text;
}

}  // namespace ray
