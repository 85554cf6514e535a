#include "source/view/panels/PanelLook.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace ray {
namespace {

constexpr double letter_height = 13;        // at scale 1: the height of Dear ImGui's own letters
constexpr float opacity_of_column = 0.94F;  // what is behind can be guessed, and letters read

/// Where Debian, Fedora and Arch keep it.
constexpr std::array letter_files{"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
                                  "/usr/share/fonts/dejavu-sans-mono-fonts/DejaVuSansMono.ttf",
                                  "/usr/share/fonts/TTF/DejaVuSansMono.ttf"};

}  // namespace

void UseLook(PanelTheme theme, double scale) {
  ImGuiStyle style;
  if (theme == PanelTheme::dark)
    ImGui::StyleColorsDark(&style);
  else
    ImGui::StyleColorsLight(&style);
  style.Colors[ImGuiCol_WindowBg].w = opacity_of_column;
  style.WindowRounding = style.ScrollbarRounding = style.GrabRounding = style.FrameRounding = 0;
  for (const int grip : {ImGuiCol_ResizeGrip, ImGuiCol_ResizeGripHovered, ImGuiCol_ResizeGripActive})
    style.Colors[grip].w = 0;  // the edge will do
  // Smooth edges are rounded differently by different GPUs.
  style.AntiAliasedLines = style.AntiAliasedLinesUseTex = style.AntiAliasedFill = false;
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
  if (file == letter_files.end() || !atlas.AddFontFromFileTTF(*file, whole_pixels.SizePixels, &whole_pixels)) {
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

}  // namespace ray
