#include "source/view/panels/HelpSheet.h"

#include <imgui.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "source/text/LowerCase.h"

namespace ray {
namespace {

constexpr std::size_t keys_wide = 20;  // letters of the column of keys; longer ones have a line of their own
constexpr int column_wide = 62;        // letters at least, of keys and what they do
constexpr int most_columns = 3;

/// Returns the number of lines of a row of text when a line holds that many letters.
std::size_t LinesOf(const HelpRow& row, int letters) {
  const std::size_t of_text = InLines(row.text, letters - static_cast<int>(keys_wide)).size();
  return row.keys.size() < keys_wide ? of_text : of_text + 1;
}

void DrawRow(PanelFrame& frame, const HelpRow& row) {
  const float indent = static_cast<float>(keys_wide) * ImGui::CalcTextSize("0").x;
  ImGui::TextDisabled("%s", row.keys.c_str());
  const bool has_room = row.keys.size() < keys_wide;
  if (has_room)
    ImGui::SameLine(indent);
  else
    ImGui::Indent(indent);
  frame.Say(row.text);
  if (!has_room) ImGui::Unindent(indent);
}

}  // namespace

std::vector<HelpSheet::Group> HelpSheet::Found() const {
  const std::string searched = LowerCase(search_.data());
  std::vector<Group> groups;
  for (const HelpRow& row : rows_) {
    if (row.keys.empty())
      groups.push_back({row.text.c_str(), {}});
    else if (LowerCase(row.keys + " " + row.text).find(searched) != std::string::npos)
      groups.back().rows.push_back(&row);
  }
  std::erase_if(groups, [](const Group& group) { return group.rows.empty(); });
  return groups;
}

void HelpSheet::Draw(PanelFrame& frame) {
  if (std::exchange(takes_focus_, false)) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  ImGui::InputTextWithHint("##help", "search; Escape closes it", search_.data(), search_.size());
  frame.Note("search");
  const std::vector<Group> groups = Found();
  if (groups.empty()) return frame.Say("nothing in the help has these words");
  ImGui::BeginChild("rows");
  const int letters = static_cast<int>(ImGui::GetContentRegionAvail().x / ImGui::CalcTextSize("0").x);
  const int columns = std::clamp(letters / column_wide, 1, most_columns);
  // Groups go down one column after the other, each to where its middle is when all are cut in equal parts.
  std::vector<std::size_t> lines;
  for (const Group& group : groups) {
    lines.push_back(2);  // of the heading, and the space below the group
    for (const HelpRow* row : group.rows) lines.back() += LinesOf(*row, letters / columns);
  }
  const std::size_t all = std::reduce(lines.begin(), lines.end());
  std::size_t before = 0;
  if (ImGui::BeginTable("groups", columns)) {
    ImGui::TableNextRow();
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const Group& group = groups[i];
      ImGui::TableSetColumnIndex(
          static_cast<int>((2 * before + lines[i]) * static_cast<std::size_t>(columns) / (2 * all)));
      ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", group.heading);
      for (const HelpRow* row : group.rows) DrawRow(frame, *row);
      ImGui::Spacing();
      before += lines[i];
    }
    ImGui::EndTable();
  }
  ImGui::EndChild();
}

}  // namespace ray
