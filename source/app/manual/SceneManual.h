#pragma once

#include <string>

namespace ray {

/// Returns the manual page scn.5 as troff source with man macros: the scene language, with every command from the
/// parser's own tables.
std::string SceneManualPage();

}  // namespace ray
