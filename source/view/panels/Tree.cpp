#include "source/view/panels/Tree.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

namespace ray {

void Tree::SetOpen(std::size_t node, bool is_open) {
  if (is_open == IsOpen(node)) return;
  if (is_open)
    open_.insert(node);
  else
    open_.erase(node);
  is_listed_ = false;
}

void Tree::Forget() {
  open_.clear();
  is_listed_ = false;
}

/// Depth first, on a stack: scenes may be as deep as memory allows.
void Tree::List(const Source& source) {
  lines_.clear();
  std::vector<std::pair<std::size_t, int>> left;
  const auto push = [&](const std::vector<std::size_t>& nodes, int depth) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) left.emplace_back(*node, depth);
  };
  push(source.roots, 0);
  while (!left.empty()) {
    const auto [node, depth] = left.back();
    left.pop_back();
    const std::vector<std::size_t> children = source.children_of(node);
    lines_.push_back({node, depth, !children.empty()});
    if (IsOpen(node)) push(children, depth + 1);
  }
  is_listed_ = true;
}

std::optional<std::size_t> Tree::Draw(PanelFrame& frame, const char* name, const Source& source, int most_lines,
                                      std::optional<std::size_t> chosen) {
  if (!is_listed_) List(source);
  const float line_height = ImGui::GetTextLineHeightWithSpacing();
  const auto height = static_cast<float>(std::min(lines_.size(), static_cast<std::size_t>(most_lines))) * line_height;
  const bool is_new = std::exchange(last_chosen_, chosen) != chosen;
  std::optional<std::size_t> clicked;
  ImGui::BeginChild(name, {0, height});
  if (is_new && chosen) {
    const auto line = std::ranges::find(lines_, *chosen, &Line::node);
    if (line != lines_.end())
      ImGui::SetScrollFromPosY(ImGui::GetCursorStartPos().y + static_cast<float>(line - lines_.begin()) * line_height -
                               ImGui::GetScrollY());
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(lines_.size()), line_height);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const Line line = lines_[static_cast<std::size_t>(i)];
      if (const auto node = DrawLine(frame, line, source, line.node == chosen)) clicked = node;
    }
  clipper.End();
  ImGui::EndChild();
  if (clicked) last_chosen_ = clicked;  // seen already: no need to scroll
  return clicked;
}

std::optional<std::size_t> Tree::DrawLine(PanelFrame& frame, const Line& line, const Source& source, bool is_chosen) {
  constexpr int deepest_indent = 12;  // levels; beyond them there is no room for words
  constexpr double step = 10;         // units of length per level
  const auto indent = static_cast<float>(std::min(line.depth, deepest_indent) * step * frame.scale);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
  if (source.color_of) {
    const Rgba color = source.color_of(line.node);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float side = ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side},
                                              IM_COL32(color[0], color[1], color[2], 255));
    ImGui::Dummy({side, side});
    ImGui::SameLine();
  }
  const std::string text = source.text_of(line.node);
  auto flags = ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth |
               ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_OpenOnDoubleClick;
  if (!line.has_children) flags |= ImGuiTreeNodeFlags_Leaf;
  if (is_chosen) flags |= ImGuiTreeNodeFlags_Selected;
  ImGui::SetNextItemOpen(IsOpen(line.node));
  const std::string fitting = Fitting(text, ImGui::GetContentRegionAvail().x - ImGui::GetTreeNodeToLabelSpacing());
  const bool is_open = ImGui::TreeNodeEx(reinterpret_cast<const void*>(line.node + 1), flags, "%s", fitting.c_str());
  frame.Note(text);
  if (fitting != text && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text.c_str());
  if (line.has_children && is_open != IsOpen(line.node)) {
    SetOpen(line.node, is_open);
    return {};
  }
  return ImGui::IsItemClicked() ? std::optional(line.node) : std::nullopt;
}

}  // namespace ray
