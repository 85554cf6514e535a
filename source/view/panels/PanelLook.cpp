#include "source/view/panels/PanelLook.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

namespace ray {
namespace {

/// The paths in Debian, Fedora and Arch.
constexpr std::array letter_files{"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
                                  "/usr/share/fonts/dejavu-sans-mono-fonts/DejaVuSansMono.ttf",
                                  "/usr/share/fonts/TTF/DejaVuSansMono.ttf"};

/// A gray, or nearly: of equal red and green.
ImVec4 Gray(float level, float blue) { return {level, level, blue, 1}; }

/// Dear ImGui's own, except those that are too faint: letters keep 4.5 : 1 to their background, and the
/// frames of clickable items 3 : 1.
///   source   W3C, Web Content Accessibility Guidelines 2.1, 1.4.3 and 1.4.11
void MakeReadable(PanelTheme theme, ImGuiStyle& style) {
  ImVec4* colors = style.Colors;
  const bool is_dark = theme == PanelTheme::dark;
  colors[ImGuiCol_TextDisabled] = is_dark ? Gray(0.65F, 0.65F) : Gray(0.35F, 0.35F);
  colors[ImGuiCol_Border] = is_dark ? Gray(0.5F, 0.55F) : Gray(0.45F, 0.5F);
  colors[ImGuiCol_ScrollbarGrab] = Gray(0.5F, 0.5F);
  colors[ImGuiCol_ScrollbarGrabHovered] = is_dark ? Gray(0.6F, 0.6F) : Gray(0.4F, 0.4F);
  colors[ImGuiCol_ScrollbarGrabActive] = is_dark ? Gray(0.7F, 0.7F) : Gray(0.3F, 0.3F);
  if (!is_dark) {
    colors[ImGuiCol_CheckMark] = colors[ImGuiCol_SliderGrab] = {0.1F, 0.35F, 0.7F, 1};
    return;
  }
  const ImVec4 under_pointer{0.14F, 0.38F, 0.66F, 1}, pressed{0.1F, 0.32F, 0.6F, 1};
  colors[ImGuiCol_ButtonHovered] = colors[ImGuiCol_HeaderHovered] = under_pointer;
  colors[ImGuiCol_ButtonActive] = colors[ImGuiCol_HeaderActive] = pressed;
  colors[ImGuiCol_FrameBgHovered] = {0.14F, 0.27F, 0.46F, 1};
  colors[ImGuiCol_FrameBgActive] = {0.12F, 0.3F, 0.52F, 1};
}

}  // namespace

void UseLook(PanelTheme theme, double scale) {
  ImGuiStyle style;
  if (theme == PanelTheme::dark)
    ImGui::StyleColorsDark(&style);
  else
    ImGui::StyleColorsLight(&style);
  MakeReadable(theme, style);
  style.Colors[ImGuiCol_WindowBg].w = 1;  // nothing is behind: the view ends at the column
  style.FrameBorderSize = static_cast<float>(std::max(1.0, std::floor(scale)));
  style.WindowRounding = style.ScrollbarRounding = style.GrabRounding = style.FrameRounding = 0;
  for (const int grip : {ImGuiCol_ResizeGrip, ImGuiCol_ResizeGripHovered, ImGuiCol_ResizeGripActive})
    style.Colors[grip].w = 0;  // the edge will do
  // Smooth edges are rounded differently by different GPUs.
  style.AntiAliasedLines = style.AntiAliasedLinesUseTex = style.AntiAliasedFill = false;
  style.CellPadding.x = 2;  // so that tables of five columns have room
  style.ScaleAllSizes(static_cast<float>(scale));
  ImGui::GetStyle() = style;
}

std::shared_ptr<const InkSheet> UseLetters(double scale) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  atlas.Flags = ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoBakedLines;
  // A texel is a pixel: letters begin at whole ones.
  ImFontConfig whole_pixels;
  whole_pixels.OversampleH = whole_pixels.OversampleV = 1;
  whole_pixels.PixelSnapH = true;
  whole_pixels.SizePixels = static_cast<float>(std::floor(letter_height * scale + 0.5));
  const auto file = std::ranges::find_if(letter_files, [](const char* name) {
    std::error_code error;
    return std::filesystem::is_regular_file(name, error);
  });
  // Latin with its accents, Greek, Cyrillic, dashes and arrows.
  static constexpr std::array<ImWchar, 13> letters{0x20,   0x24F,  0x370,  0x3FF,  0x400,  0x52F, 0x2010,
                                                   0x205E, 0x2190, 0x21FF, 0x2200, 0x22FF, 0};
  if (file == letter_files.end() ||
      !atlas.AddFontFromFileTTF(*file, whole_pixels.SizePixels, &whole_pixels, letters.data())) {
    // Drawn for one size; others are multiples of it.
    whole_pixels.SizePixels = static_cast<float>(letter_height * std::max(1.0, std::floor(scale)));
    atlas.AddFontDefault(&whole_pixels);
  }
  auto sheet = std::make_shared<InkSheet>();
  unsigned char* ink = nullptr;
  atlas.GetTexDataAsAlpha8(&ink, &sheet->width, &sheet->height);
  sheet->ink.assign(ink, ink + static_cast<std::size_t>(sheet->width) * static_cast<std::size_t>(sheet->height));
  return sheet;
}

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
