#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "source/view/panels/Panel.h"

namespace ray {

/// A tree of which only open parts are listed, and only visible rows are drawn: trees may have a million
/// nodes. Nodes are numbers.
class Tree {
 public:
  struct Source {
    std::vector<std::size_t> roots;
    std::function<std::vector<std::size_t>(std::size_t)> children_of;
    std::function<std::string(std::size_t)> text_of;
    std::function<Rgba(std::size_t)> color_of{};  // of the swatch before the text; empty for none
  };

  /// Returns true if the node's children are listed.
  bool IsOpen(std::size_t node) const { return open_.contains(node); }
  void SetOpen(std::size_t node, bool is_open);
  /// Closes everything, for another tree.
  void Forget();
  /// The list, with `chosen` marked; where that is another than the last time, it is scrolled to.
  ///   most_lines   of its height
  ///   returns      the node that was clicked
  std::optional<std::size_t> Draw(PanelFrame& frame, const char* name, const Source& source, int most_lines,
                                  std::optional<std::size_t> chosen);

 private:
  struct Line {
    std::size_t node = 0;
    int depth = 0;
    bool has_children = false;
  };
  void List(const Source& source);
  std::optional<std::size_t> DrawLine(PanelFrame& frame, const Line& line, const Source& source, bool is_chosen);

  std::set<std::size_t> open_;
  std::vector<Line> lines_;
  bool is_listed_ = false;
  std::optional<std::size_t> last_chosen_;
};

}  // namespace ray
