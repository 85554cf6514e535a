#include "source/view/panels/Labels.h"

#include <imgui.h>

#include <cmath>
#include <limits>

namespace ray {
namespace {

constexpr double line_spacing = 3;  // units of length from one line to the next
constexpr double ground_margin = 2;

}  // namespace

LetterSize LettersOfLabels(double scale) {
  // Outside of a frame no font is current.
  const ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
  const ImVec2 letter = font.CalcTextSizeA(font.FontSize, std::numeric_limits<float>::max(), 0, "0");
  return {static_cast<double>(letter.x), static_cast<double>(letter.y) + std::round(line_spacing * scale)};
}

void DrawLabels(std::span<const Label> labels, double scale, PanelTheme theme) {
  const auto height = static_cast<float>(LettersOfLabels(scale).height),
             margin = static_cast<float>(ground_margin * scale);
  const float space = std::floor((height - ImGui::GetFontSize()) / 2);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (const Label& label : labels) {
    // Whole pixels, so that a texel of a letter is one.
    const auto left = static_cast<float>(std::floor(label.x + 0.5));
    const float top = ImGui::GetIO().DisplaySize.y - static_cast<float>(std::floor(label.y + 0.5)) - height;
    const char *begin = label.text.data(), *end = begin + label.text.size();
    const float width = ImGui::CalcTextSize(begin, end).x;
    if (width == 0) continue;
    const bool is_light = theme == PanelTheme::light;
    const auto& [red, green, blue, alpha] = is_light ? Label::OnLight(label.color) : label.color;
    const int gray = is_light ? Label::light_ground : 0;
    const int opacity = (is_light ? Label::light_ground_alpha : Label::ground_alpha) * alpha / 255;
    list.AddRectFilled({left - margin, top}, {left + width + margin, top + height},
                       IM_COL32(gray, gray, gray, opacity));
    list.AddText({left, top + space}, IM_COL32(red, green, blue, alpha), begin, end);
  }
}

}  // namespace ray
