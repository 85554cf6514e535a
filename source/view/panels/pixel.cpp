#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <utility>

#include "source/inspect/PixelExplanation.h"
#include "source/text/NumberText.h"
#include "source/view/commands/Commands.h"
#include "source/view/panels/Panel.h"
#include "source/view/panels/Tree.h"

// What a pixel shows, and the rays behind it.
namespace ray {
namespace {

constexpr int pixel_lines = 16;

std::string LengthOf(const RecordedRay& ray) {
  const auto end = ray.End();
  return end ? Brief(Length(*end - ray.ray.At(ray.ray.t_min))) : "endless";
}

/// Short lines of those colors on the black of an image that is dark; whatever the theme, they are seen on it.
void DrawSwatch(std::span<const Rgba> colors) {
  constexpr float letters_wide = 4, thickness = 0.15F;  // of a line's height
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = std::floor(letters_wide * ImGui::CalcTextSize("0").x), height = ImGui::GetFrameHeight();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + height}, IM_COL32_BLACK);
  const float step = height / static_cast<float>(colors.size() + 1), half = std::max(1.0F, thickness * height / 2);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const Rgba& c = colors[i];
    const float middle = std::floor(at.y + static_cast<float>(i + 1) * step);
    list.AddRectFilled({at.x, middle - half}, {at.x + width, middle + half}, IM_COL32(c[0], c[1], c[2], 255));
  }
  ImGui::Dummy({width, height});
  ImGui::SameLine();
}

/// Draws the legend of the colors of rays, with switches.
void DrawLegend(PanelFrame& frame) {
  constexpr std::array names{"from the camera", "to lights; blocked", "reflected; scattered", "transmitted"};
  static_assert(names.size() == shown_ray_kinds);
  ImGui::Separator();
  const RayLook& look = frame.viewer.rays.Look();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto kind = static_cast<ShownRays>(i);
    DrawSwatch(ColorsOf(kind));
    if (frame.Check(names[i], look.shows[i])) frame.Ask([kind](ViewerState& v) { ToggleRays(v, kind); });
  }
  DrawSwatch(std::array<Rgba, 1>{ColorOfNormals()});
  if (frame.Check("normals", look.normals)) frame.Ask([](ViewerState& v) { ToggleNormals(v); });
  if (frame.viewer.rays.Foreign().empty()) return;
  DrawSwatch(std::array<Rgba, 1>{ColorOfForeign()});
  frame.Say("of another tracer");
}

/// Draws the fields for the numbers of traced rays.
void DrawCounts(PanelFrame& frame) {
  const DebugRayCounts now = frame.viewer.rays.Counts();
  constexpr int most = 4096;
  const auto number = [&](const char* name, int DebugRayCounts::*count) {
    int value = now.*count;
    ImGui::SetNextItemWidth(8 * ImGui::CalcTextSize("0").x);
    const bool is_typed = ImGui::InputInt(name, &value, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue);
    frame.Note(name);
    if (!is_typed) return;
    DebugRayCounts counts = now;
    counts.*count = std::clamp(value, 1, most);
    frame.Ask([counts](ViewerState& v) { SetDebugRays(v, counts); });
  };
  number("camera rays per pixel", &DebugRayCounts::camera);
  number("shadow rays per light", &DebugRayCounts::shadow);
  number("pixels of the cut", &DebugRayCounts::in_cut);
}

class PixelPanel : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    if (const auto& pick = frame.viewer.selection.pick)
      for (const std::string& line : pick->text) frame.Say(line);
    const auto& pixel = frame.viewer.rays.Pixel();
    if (!pixel) frame.Say("Right-click a pixel: its rays are listed here.");
    if (pixel) DrawPixel(frame, *pixel);
    if (pixel || frame.viewer.rays.ShowsGrid() || frame.viewer.section.IsShown()) {
      DrawLegend(frame);
      DrawCounts(frame);
    }
  }

 private:
  void DrawPixel(PanelFrame& frame, const PixelTrace& pixel) {
    if (frame.viewer.selection.pick) ImGui::Separator();
    frame.Say("rays of pixel " + std::to_string(pixel.column) + " " + std::to_string(pixel.row) + ": " +
              Brief(pixel.Mean()));
    frame.Say("kind, luminance it contributes | length, what it hits");
    Read(frame, pixel);
    DrawTree(frame, pixel);
    if (!explanation_.empty()) frame.Say(explanation_);
    if (const auto& difference = frame.viewer.rays.Difference()) frame.Say("the other tracer: " + difference->text);
    const auto chosen = frame.viewer.rays.Look().chosen;
    if (!chosen) return;
    DrawRay(frame, pixel.rays[*chosen]);
    frame.Fact("subtree", Brief(contribution_[*chosen]) + " contributed in all");
    if (frame.Check("counts", !left_out_.contains(*chosen)))
      if (left_out_.erase(*chosen) == 0) left_out_.insert(*chosen);
    if (!left_out_.empty()) DrawRest(frame, pixel);
  }

  /// The color of the pixel without the rays that are switched off, as a swatch and in numbers.
  void DrawRest(PanelFrame& frame, const PixelTrace& pixel) const {
    R2::Color rest = pixel.Mean();
    for (const std::size_t ray : left_out_) {
      bool is_counted = false;  // with one that it comes from
      for (int up = pixel.rays[ray].parent; up != RecordedRay::none;
           up = pixel.rays[static_cast<std::size_t>(up)].parent)
        is_counted |= left_out_.contains(static_cast<std::size_t>(up));
      if (!is_counted) rest = rest - contribution_[ray] / static_cast<double>(pixel.samples.size());
    }
    DrawSwatch(std::array<Rgba, 1>{AsSeen(frame, rest)});
    frame.Fact("pixel without", Brief(rest));
  }

  static Rgba AsSeen(const PanelFrame& frame, const R2::Color& light) {
    return Shown(frame.viewer.settings.render.srgb ? EncodeSrgb(Clamped(light)) : light);
  }

  /// Reads the tree of rays and the contribution of each subtree, again for each trace of a pixel.
  void Read(const PanelFrame& frame, const PixelTrace& pixel) {
    const int trace = frame.viewer.rays.TraceNumber();
    const R2::Image* const reference = frame.viewer.traced.Reference().get();
    if (std::exchange(trace_, trace) == trace && std::exchange(reference_, reference) == reference) return;
    rays_.Forget();
    children_ = pixel.Children();
    contribution_ = SubtreeLight(pixel);
    roots_.clear();
    left_out_.clear();
    for (std::size_t i = 0; i < pixel.rays.size(); ++i)
      if (pixel.rays[i].parent == RecordedRay::none) roots_.push_back(i);
    const auto light = [&](std::size_t i) { return -Luminance(contribution_[i]); };
    for (auto& children : children_) std::ranges::stable_sort(children, {}, light);
    if (roots_.size() == 1) rays_.SetOpen(roots_[0], true);
    Explain(frame, pixel);
  }

  /// Explains why the pixel differs from the reference, if there is one of its image.
  void Explain(const PanelFrame& frame, const PixelTrace& pixel) {
    explanation_.clear();
    const std::shared_ptr<const R2::Image>& reference = frame.viewer.traced.Reference();
    const RenderSettings& settings = frame.viewer.rays.PixelSettings();
    if (!reference || reference->Width() != settings.width || reference->Height() != settings.height) return;
    const R2::Color wanted = reference->At(pixel.column, pixel.row);
    explanation_ = "reference " + Brief(wanted);
    if (const auto why = ExplainPixel(pixel, wanted, frame.viewer.scene.Loaded(), settings))
      explanation_ += ": " + why->text;
  }

  void DrawTree(PanelFrame& frame, const PixelTrace& pixel) {
    const World& world = frame.viewer.scene.world();
    const auto text_of = [&](std::size_t i) {
      const RecordedRay& ray = pixel.rays[i];
      const std::string hit = HitBy(ray, world);
      std::string text = ray_kind_names[static_cast<std::size_t>(ray.kind)];
      if (ray.kind == RayKind::shadow) text += " to " + ray.towards.substr(0, ray.towards.find(' '));
      text += " " + Rounded(Luminance(contribution_[i]), 3) + " | " + LengthOf(ray);
      if (!hit.empty()) text += (ray.kind == RayKind::shadow ? " blocked by " : " to ") + hit;
      return text;
    };
    const auto chosen = frame.viewer.rays.Look().chosen;
    const auto color_of = [&](std::size_t i) {
      return AsSeen(frame, left_out_.contains(i) ? R2::Color{}
                                                 : contribution_[i] / static_cast<double>(pixel.samples.size()));
    };
    const auto clicked = rays_.Draw(
        frame, "rays", {roots_, [&](std::size_t i) { return children_[i]; }, text_of, color_of}, pixel_lines, chosen);
    if (!clicked) return;
    frame.Ask(
        [ray = *clicked, chosen](ViewerState& v) { ChooseRay(v, ray == chosen ? std::nullopt : std::optional(ray)); });
  }

  static void DrawRay(PanelFrame& frame, const RecordedRay& ray) {
    ImGui::Separator();
    frame.Fact("from", Brief(ray.ray.origin));
    frame.Fact("along", Brief(Unit(ray.ray.direction)) + (ray.is_inside ? ", inside" : ""));
    if (!ray.towards.empty()) frame.Fact("toward", Brief(ray.towards));
    frame.Fact("length", LengthOf(ray));
    const std::string hit = HitBy(ray, frame.viewer.scene.world());
    if (!hit.empty()) frame.Fact(ray.kind == RayKind::shadow ? "blocked" : "hits", hit);
    if (ray.at) frame.Fact("normal", Brief(AsVector(ray.at->shading_normal)));
    frame.Fact("throughput", Brief(ray.throughput));
    frame.Fact("contribution", Brief(ray.contribution));
  }

  int trace_ = 0;  // as RayInspector counts, from 1
  const R2::Image* reference_ = nullptr;
  Tree rays_;
  std::vector<std::size_t> roots_;                  // the rays from the camera
  std::vector<std::vector<std::size_t>> children_;  // of each ray
  std::vector<R2::Color> contribution_;             // of each, with all that it leads to
  std::set<std::size_t> left_out_;                  // of the color of the pixel
  std::string explanation_;                         // of its difference from the reference; empty without one
};

}  // namespace

extern const PanelPart pixel_part{"pixel", [] { return std::unique_ptr<Panel>(new PixelPanel); }};

}  // namespace ray
