#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "tests/source/view/ScriptedViewer.h"
#include "tests/source/view/WithOptions.h"

namespace ray {

/// A viewer whose user clicks in panels, by the names of their items.
template <int width_of_drawing, int height_of_drawing>
class UserOfPanels : public ScriptedViewer<WithOptions, width_of_drawing, height_of_drawing> {
 protected:
  using ScriptedViewer<WithOptions, width_of_drawing, height_of_drawing>::viewer_;

  /// Returns the first item whose name begins so.
  std::optional<PanelItem> Find(const std::string& start) {
    viewer_->Show();
    viewer_->Reveal(start);
    const auto& items = viewer_->ItemsOfPanels();
    const auto found = std::ranges::find_if(items, [&](const PanelItem& i) { return i.name.starts_with(start); });
    return found == items.end() ? std::nullopt : std::optional(*found);
  }
  bool HasItem(const std::string& start) { return Find(start).has_value(); }
  void Click(const std::string& start, double right_of_middle = 0) {
    const auto item = Find(start);
    ASSERT_TRUE(item) << "there is no " << start << " in\n" << viewer_->TextOfPanels();
    this->Do("click left " + std::to_string(item->x + right_of_middle) + " " + std::to_string(item->y));
  }
  bool Says(const std::string& words) { return viewer_->TextOfPanels().find(words) != std::string::npos; }
};

class PanelTest : public UserOfPanels<512, 512> {};

}  // namespace ray
