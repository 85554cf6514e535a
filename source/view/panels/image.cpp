#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "R1/Elementary.h"
#include "source/text/NumberText.h"
#include "source/view/commands/Commands.h"
#include "source/view/compare/Histogram.h"
#include "source/view/panels/Panel.h"

// The rendered image: its exposure, how its values are spread, and the images made before it.
namespace ray {
namespace {

constexpr double most_stops = 8, step_of_slider = 0.05;
constexpr double plot_height = 80;  // units of length

class ImagePanel : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    DrawExposure(frame);
    DrawHistogram(frame);
    DrawStrip(frame);
  }

 private:
  static void DrawExposure(PanelFrame& frame) {
    auto stops = static_cast<float>(frame.viewer.exposure_steps);
    constexpr auto most = static_cast<float>(most_stops);
    frame.Fact("exposure", Rounded(frame.viewer.exposure_steps, 4) + " stops");
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const bool is_moved = ImGui::SliderFloat("##exposure", &stops, -most, most, "");
    frame.Note("slide exposure");
    if (!is_moved) return;
    const double rounded = std::round(static_cast<double>(stops) / step_of_slider) * step_of_slider;
    frame.Ask([rounded](ViewerState& v) { SetExposure(v, rounded); });
  }

  void DrawHistogram(PanelFrame& frame) {
    const TracedImages& traced = frame.viewer.traced;
    const RenderJob* job = traced.Job();
    if (!job) return frame.Say("S or P renders an image, whose values are then counted here");
    const Seen now{traced.JobNumber(), job->Samples(), job->HasEnded(), frame.viewer.exposure_steps};
    if (!(now == seen_)) {
      seen_ = now;
      if (const auto image = traced.Current()) histogram_ = HistogramOf(*image, R1::Exp2(now.stops));
    }
    Plot(frame);
    const auto all = static_cast<double>(std::max<std::int64_t>(1, histogram_.pixels));
    const auto percent = [&](std::int64_t count) { return Rounded(100 * static_cast<double>(count) / all, 3) + "%"; };
    frame.Fact("too bright", percent(histogram_.above) + " of the pixels are above 1");
    if (histogram_.below > 0) frame.Fact("below 0", percent(histogram_.below));
    if (histogram_.not_finite > 0) frame.Fact("not finite", std::to_string(histogram_.not_finite));
    frame.Fact("mean", Brief(histogram_.mean));
    frame.Fact("brightest", Brief(histogram_.brightest));
  }

  /// Bars of the square roots of the counts, so that few pixels are seen next to many.
  void Plot(const PanelFrame& frame) const {
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = static_cast<float>(plot_height * frame.scale);
    ImGui::Dummy({width, height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(from, {from.x + width, from.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg));
    std::int64_t most = 1;
    for (const auto& channel : histogram_.counts)
      for (const std::int64_t count : channel) most = std::max(most, count);
    constexpr ImU32 colors[] = {IM_COL32(230, 60, 60, 110), IM_COL32(50, 180, 60, 110), IM_COL32(70, 100, 240, 110)};
    const float step = width / static_cast<float>(Histogram::bins);
    for (std::size_t channel = 0; channel < histogram_.counts.size(); ++channel)
      for (std::size_t bin = 0; bin < Histogram::bins; ++bin) {
        const double share = static_cast<double>(histogram_.counts[channel][bin]) / static_cast<double>(most);
        const float x = from.x + static_cast<float>(bin) * step, y = static_cast<float>(std::sqrt(share)) * height;
        list.AddRectFilled({x, from.y + height - y}, {x + step, from.y + height}, colors[channel]);
      }
  }

  static void DrawStrip(PanelFrame& frame) {
    const ImageStrip& strip = frame.viewer.images;
    ImGui::Separator();
    if (strip.All().empty()) return frame.Say("Finished images are listed here; a click shows one instead of the last");
    frame.Say("images made, Control+Page Up and Down flip them");
    for (std::size_t i = 0; i < strip.All().size(); ++i) {
      const KeptImage& kept = strip.All()[i];
      const bool is_shown = ShownImage(frame.viewer) == i;
      ImGui::PushID(static_cast<int>(i));
      const std::string name = "image " + std::to_string(strip.NumberOf(i)) + ": " +
                               std::to_string(kept.image->Width()) + "x" + std::to_string(kept.image->Height()) + ", " +
                               Rounded(kept.samples, 4) +
                               (kept.samples == 1 ? " sample, " : " samples, ") + Rounded(kept.seconds, 3) + " s";
      if (frame.Choice(name, is_shown))
        frame.Ask([i, is_shown](ViewerState& v) { ShowImage(v, is_shown ? std::nullopt : std::optional(i)); });
      ImGui::PopID();
      if (!is_shown) continue;
      if (!kept.claim.empty()) frame.Say(kept.claim);
      frame.Say(kept.command.empty() ? kept.scene : kept.command);
    }
  }

  /// The image of the histogram.
  struct Seen {
    std::uint64_t job = 0;
    int samples = 0;
    bool has_ended = false;
    double stops = 0;
    friend bool operator==(const Seen&, const Seen&) = default;
  };
  Seen seen_;
  Histogram histogram_;
};

}  // namespace

extern const PanelPart image_part{"image", [] { return std::unique_ptr<Panel>(new ImagePanel); }};

}  // namespace ray
