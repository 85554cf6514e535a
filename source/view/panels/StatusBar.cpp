#include "source/view/panels/Panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "source/view/HelpText.h"

namespace ray {
namespace {

constexpr float bar_letters = 10;  // of the progress bar

/// Returns a name of at most that many letters: a longer one without its middle.
///   text   UTF-8
std::string Shortened(const std::string& text, std::size_t most) {
  if (CountLetters(text) <= most) return text;
  const auto continues = [&](std::size_t i) { return i < text.size() && (text[i] & 0xC0) == 0x80; };
  const std::size_t half = (most - 2) / 2;  // letters on either side of two dots
  std::size_t end = 0, begin = text.size();
  for (std::size_t i = 0; i < half; ++i) {
    do ++end;
    while (continues(end));
    do --begin;
    while (begin > 0 && continues(begin));
  }
  return text.substr(0, end) + ".." + text.substr(begin);
}

std::string NameAndSize(const ViewerState& viewer) {
  constexpr std::size_t longest = 28;  // letters, so that the progress has room
  return Shortened(std::filesystem::path(viewer.settings.scene).filename().string(), longest) +
         (viewer.editor.HasUnsaved() ? "* " : " ") + std::to_string(viewer.screen.size.width) + "x" +
         std::to_string(viewer.screen.size.height);
}

/// "120 45  0.31 0.2 0.9": of the image that is rendered; empty where the pointer is not on it.
std::string PixelUnderPointer(const ViewerState& viewer, const RenderJob& job) {
  const R2::Point& pointer = viewer.PointerInShownImage();
  const auto x = static_cast<int>(std::floor(pointer.x)), y = static_cast<int>(std::floor(pointer.y));
  const PixelRectangle region = RegionOf(job.Settings());
  if (!region.Contains(x, y)) return {};
  return std::to_string(x) + " " + std::to_string(y) + "  " + Brief(job.frame().At(x - region.x0, y - region.y0));
}

}  // namespace

void DrawStatusBar(PanelFrame& frame) {
  const ViewerState& viewer = frame.viewer;
  const float letter = ImGui::CalcTextSize("0").x, all = ImGui::GetContentRegionAvail().x,
              from = ImGui::GetCursorPosX();
  constexpr const char* keys = "H help  Tab panels";
  constexpr float least_letters = 70;  // of the bar, below which the progress needs all of it
  const float room_for_keys = all > least_letters * letter ? letter * static_cast<float>(CountLetters(keys) + 2) : 0;
  if (room_for_keys > 0) {
    ImGui::SetCursorPosX(from + all - room_for_keys + 2 * letter);
    ImGui::TextUnformatted(keys);
    ImGui::SameLine(from);
  }
  ImGui::TextUnformatted(NameAndSize(viewer).c_str());
  const RenderJob* job = viewer.traced.Job();
  if (!job) return;
  ImGui::SameLine();
  if (const auto share = job->HasEnded() ? std::nullopt : job->Share()) {
    ImGui::ProgressBar(static_cast<float>(*share), {bar_letters * letter, ImGui::GetTextLineHeight()}, "");
    ImGui::SameLine();
  }
  const std::string pixel = PixelUnderPointer(viewer, *job);
  const float pixel_at = from + all - room_for_keys - letter * static_cast<float>(CountLetters(pixel));
  ImGui::TextUnformatted(Fitting(viewer.status.Text(), pixel_at - letter - ImGui::GetCursorPosX()).c_str());
  if (pixel.empty()) return;
  ImGui::SameLine(std::max(from, pixel_at));
  ImGui::TextUnformatted(pixel.c_str());
}

}  // namespace ray
