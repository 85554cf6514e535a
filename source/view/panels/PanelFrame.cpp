#include <imgui.h>
#include <imgui_internal.h>  // LogEnabled

#include <algorithm>
#include <string_view>

#include "source/text/Number.h"
#include "source/text/NumberText.h"
#include "source/view/HelpText.h"
#include "source/view/panels/Panel.h"

namespace ray {

std::string Fitting(const std::string& text, float room) {
  const auto letters = static_cast<std::size_t>(std::max(0.0F, room / ImGui::CalcTextSize("0").x));
  if (text.size() <= letters || ImGui::GetCurrentContext()->LogEnabled) return text;
  constexpr std::size_t dots = 2;
  return text.substr(0, letters > dots ? letters - dots : 0) + "..";
}

bool PanelFrame::Button(const std::string& name) {
  const bool is_clicked = ImGui::Button(name.c_str());
  Note(name);
  return is_clicked;
}

bool PanelFrame::Choice(const std::string& name, bool is_chosen) {
  // The part after the signs distinguishes lines that begin alike, and is not shown.
  const std::string fitting = Fitting(name, ImGui::GetContentRegionAvail().x);
  const bool is_clicked = ImGui::Selectable((fitting + "##" + name).c_str(), is_chosen);
  Note(name);
  if (fitting != name && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", name.c_str());
  return is_clicked;
}

bool PanelFrame::Check(const std::string& name, bool is_on) {
  const bool is_clicked = ImGui::Checkbox(name.c_str(), &is_on);
  Note(name);
  return is_clicked;
}

bool PanelFrame::Word(const char* name, bool is_it) {
  const bool is_clicked = ImGui::RadioButton(name, is_it);
  Note(name);
  return is_clicked && !is_it;
}

bool PanelFrame::Heading(const char* name, bool is_open_at_first) {
  const bool is_open = ImGui::CollapsingHeader(name, is_open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  Note(name);
  return is_open;
}

void PanelFrame::Say(const std::string& text) {
  const float room = ImGui::GetContentRegionAvail().x, letter = ImGui::CalcTextSize("0").x;
  // Dear ImGui would break numbers at their point as well. Scripts get the text in one line.
  const bool is_logged = ImGui::GetCurrentContext()->LogEnabled;
  if (is_logged || ImGui::CalcTextSize(text.c_str()).x <= room) return ImGui::TextUnformatted(text.c_str());
  std::string lines;
  for (const std::string& line : InLines(text, static_cast<int>(room / letter)))
    lines += (lines.empty() ? "" : "\n") + line;
  ImGui::TextUnformatted(lines.c_str());
}

void PanelFrame::Fact(const std::string& name, const std::string& value) {
  constexpr float letters = 14;  // of the margin, the longest usual name and a space
  ImGui::TextDisabled("%s", name.c_str());
  ImGui::SameLine(letters * ImGui::CalcTextSize("0").x);
  Say(value);
}

void PanelFrame::Note(const std::string& name) {
  if (!sought_.empty() && name.starts_with(sought_)) {
    const float middle = (ImGui::GetItemRectMin().y + ImGui::GetItemRectMax().y) / 2, top = ImGui::GetWindowPos().y;
    if (middle < top || middle > std::min(top + ImGui::GetWindowHeight(), ImGui::GetIO().DisplaySize.y))
      ImGui::SetScrollHereY();
    sought_.clear();
  }
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  items_.push_back({name, (low.x + high.x) / 2, ImGui::GetIO().DisplaySize.y - (low.y + high.y) / 2});
}

std::string Brief(double number) {
  constexpr int digits = 4;  // an eye compares them
  return Plain(number, digits);
}
std::string Brief(const R2::Color& c) { return Brief(c.r) + " " + Brief(c.g) + " " + Brief(c.b); }
std::string Brief(const R3::Point& p) { return Brief(p.x) + " " + Brief(p.y) + " " + Brief(p.z); }
std::string Brief(const R3::Vector& v) { return Brief(v.x) + " " + Brief(v.y) + " " + Brief(v.z); }

std::string Brief(const std::string& words) {
  std::string text;
  for (std::size_t start = 0; start < words.size();) {
    const std::size_t end = std::min(words.find_first_of(" ,", start), words.size() - 1) + 1;
    const std::size_t length = end - start - (words[end - 1] == ' ' || words[end - 1] == ',');
    const auto number = ParseNumber(std::string_view(words).substr(start, length));
    text += number.problem ? words.substr(start, length) : Brief(number.value);
    text += words.substr(start + length, end - start - length);
    start = end;
  }
  return text;
}

}  // namespace ray
