#pragma once

#include <string_view>

namespace ray {

/// What a file looks like by its first bytes, for messages about one that is not what its name says.
struct FileLook {
  const char* what;  // "a web page"; null where nothing is known
  const char* hint;  // what to do about it, or nothing
};

/// Knows what is easily taken for a mesh or found under the name of one. It proves nothing: only the message about a
/// file that could not be read should use it.
FileLook LookOf(std::string_view bytes);

}  // namespace ray
