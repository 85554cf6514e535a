#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "R1/Elementary.h"
#include "R2/ImageFile.h"
#include "source/integrate/Integrators.h"
#include "source/integrate/debug/Heat.h"
#include "source/render/Layer.h"
#include "source/text/EnumNames.h"
#include "source/view/commands/Commands.h"
#include "source/view/panels/Panel.h"

// The meaning of the colors of the traced image, and the number under the pointer.
namespace ray {
namespace {

ImU32 InkOf(const R2::Color& color) {
  return IM_COL32(R2::ToByte(color.r), R2::ToByte(color.g), R2::ToByte(color.b), 255);
}

/// Draws a bar as wide as the panel, in the colors of `color_at` from 0 to 1, labeled at both ends and in the middle.
template <typename ColorAt>
void DrawBar(const ColorAt& color_at, const std::string& low, const std::string& middle, const std::string& high) {
  constexpr int pieces = 64;  // finer than eyes distinguish hues
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
  for (int i = 0; i < pieces; ++i) {
    const auto edge = [&](int k) { return std::floor(at.x + width * static_cast<float>(k) / pieces); };
    ImGui::GetWindowDrawList()->AddRectFilled({edge(i), at.y}, {edge(i + 1), at.y + height},
                                              InkOf(color_at((i + 0.5) / pieces)));
  }
  ImGui::Dummy({width, height});
  const float left = ImGui::GetCursorPosX();
  ImGui::TextUnformatted(low.c_str());
  ImGui::SameLine(left + (width - ImGui::CalcTextSize(middle.c_str()).x) / 2);
  ImGui::TextUnformatted(middle.c_str());
  ImGui::SameLine(left + width - ImGui::CalcTextSize(high.c_str()).x);
  ImGui::TextUnformatted(high.c_str());
}

/// Returns the nearest and the farthest depth of all hits; std::nullopt without hits.
std::optional<std::pair<double, double>> DepthsOf(const R2::Image& image) {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (const float depth : image.Channels())
    if (depth > 0) nearest = std::min<double>(nearest, depth), farthest = std::max<double>(farthest, depth);
  if (!(farthest > 0)) return {};
  return std::pair{nearest, farthest};
}

class LayersPanel : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const TracedImages& traced = frame.viewer.traced;
    const RenderJob* job = traced.IsLive() ? traced.Live() : nullptr;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize("live").x -
                            ImGui::GetStyle().ItemInnerSpacing.x);
    if (ImGui::BeginCombo("live", job ? NameOf(job->Settings().mode) : "off")) {
      DrawModes(frame, job);
      ImGui::EndCombo();
    }
    frame.Note("live");
    if (!job) return;
    frame.Say(KindOf(job->Settings().mode).about);
    DrawScale(job->Settings().mode, job->frame());
    DrawValue(frame, *job);
  }

 private:
  static void DrawModes(PanelFrame& frame, const RenderJob* job) {
    if (frame.Choice("off", !job) && job) frame.Ask(ShowPreview);
    for (std::size_t i = 0; i < render_modes.size(); ++i) {
      const auto mode = static_cast<RenderMode>(i);
      if (frame.Choice(render_modes[i], job && job->Settings().mode == mode))
        frame.Ask([mode](ViewerState& v) { ShowTraced(v, mode); });
    }
  }

  static void DrawScale(RenderMode mode, const Frame& frame) {
    if (ShowsCosts(mode)) {
      constexpr double decades = 4;  // of the scale of HeatColor
      DrawBar([](double share) { return HeatColor(R1::Pow(10, decades * share)); }, "1", "100", "10000");
    } else if (mode == RenderMode::depth) {
      const auto depths = DepthsOf(frame.Image());
      if (!depths) return;
      R2::Image ramp(2, 1);  // as the image is shown: by its own nearest and farthest
      ramp.Set(0, 0, {depths->first, depths->first, depths->first});
      ramp.Set(1, 0, {depths->second, depths->second, depths->second});
      const R2::Image shown = LayerAsShown(mode, ramp);
      DrawBar([&](double share) { return (1 - share) * shown.At(0, 0) + share * shown.At(1, 0); }, Brief(depths->first),
              Brief((depths->first + depths->second) / 2), Brief(depths->second));
    } else if (mode == RenderMode::normal) {
      DrawBar([](double share) { return R2::Color{share, 0.5, 0.5}; }, "x -1", "0", "1");
      DrawBar([](double share) { return R2::Color{0.5, share, 0.5}; }, "y -1", "0", "1");
      DrawBar([](double share) { return R2::Color{0.5, 0.5, share}; }, "z -1", "0", "1");
    } else if (mode == RenderMode::uv) {
      DrawBar([](double share) { return R2::Color{share, 0, 0}; }, "u 0", "0.5", "1");
      DrawBar([](double share) { return R2::Color{0, share, 0}; }, "v 0", "0.5", "1");
    }
  }

  /// The number that the color below the pointer stands for.
  static void DrawValue(PanelFrame& frame, const RenderJob& job) {
    const auto& pointer = frame.viewer.PointerInShownImage();
    const Frame& image = job.frame();
    const auto x = static_cast<int>(std::floor(pointer.x)), y = static_cast<int>(std::floor(pointer.y));
    if (x < 0 || y < 0 || x >= image.Width() || y >= image.Height()) return;
    const R2::Color value = image.At(x, y);
    const RenderMode mode = job.Settings().mode;
    const bool is_one_number = mode == RenderMode::depth || mode == RenderMode::id;
    frame.Fact("pixel", std::to_string(x) + " " + std::to_string(y));
    frame.Fact("value", ShowsCosts(mode) ? Brief(HeatOf(value)) : is_one_number ? Brief(value.r) : Brief(value));
  }
};

}  // namespace

extern const PanelPart layers_part{"layers", [] { return std::unique_ptr<Panel>(new LayersPanel); }};

}  // namespace ray
