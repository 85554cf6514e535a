#pragma once

#include <string>

namespace ray {

/// The manual page scn.5: the scene language, every command of it from the parser's own tables, in the language of the
/// man macros.
std::string SceneManualPage();

}  // namespace ray
