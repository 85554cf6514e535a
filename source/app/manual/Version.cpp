// Compiled separately, since the Makefile passes the commit on its command line: a new commit recompiles only this.
#include <string_view>

#include "source/app/manual/Manual.h"

#ifndef RAYPRO_COMMIT
#define RAYPRO_COMMIT ""
#endif

namespace ray {

std::string NameAndVersion(const Program& program) { return NameOf(program) + " " RAYPRO_VERSION; }

std::string Version(const Program& program) {
  constexpr std::string_view commit = RAYPRO_COMMIT;
  const std::string built_from = commit.empty() ? "" : "\nbuilt from: commit " + std::string(commit);
  return NameAndVersion(program) + built_from + "\nbuilt with: " RAYPRO_FEATURES "\n";
}

}  // namespace ray
