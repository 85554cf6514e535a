#pragma once

#include <functional>
#include <string>
#include <vector>

#include "source/view/HelpText.h"
#include "source/view/ViewerState.h"

namespace ray {

/// A key and what it does. All keys are in one table, of which the help is made.
struct KeyBinding {
  Key key;
  Modifiers modifiers;
  const char* help;  // empty: as the line before
  std::function<void(ViewerState&)> act;
  std::function<void(ViewerState&)> release = nullptr;  // for actions that last as long as the key is held
};

const std::vector<KeyBinding>& KeyBindings();

/// Gestures and keys in groups, a line each.
std::vector<HelpRow> RowsOfHelp();
std::vector<std::string> LinesOfHelp();

}  // namespace ray
