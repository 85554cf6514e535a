#pragma once

#include <array>
#include <vector>

#include "source/view/HelpText.h"
#include "source/view/KeyBindings.h"
#include "source/view/panels/Panel.h"

namespace ray {

/// The actions of mouse and keys, which can be searched: a sheet in the middle of the view.
class HelpSheet {
 public:
  /// Begins a new search: typed text becomes the search text.
  void Open() { search_ = {}, takes_focus_ = true; }
  /// Draws it in the current window of Dear ImGui.
  void Draw(PanelFrame& frame);

 private:
  /// The rows below a heading that contain the search text.
  struct Group {
    const char* heading;
    std::vector<const HelpRow*> rows;
  };
  std::vector<Group> Found() const;

  const std::vector<HelpRow> rows_ = RowsOfHelp();
  std::array<char, 64> search_{};  // longer than any word of the help
  bool takes_focus_ = false;
};

}  // namespace ray
