#pragma once

#include <filesystem>

#include "tests/Project.h"

namespace ray {

/// The sample scenes in a folder of their own, to be written to.
class CopiedScenes {
 public:
  CopiedScenes() {
    for (const char* part : {"hello.scn", "glass.scn", "empty.scn", "meshes", "textures"})
      std::filesystem::copy(project::Root() / "scenes" / part, folder_ / part,
                            std::filesystem::copy_options::recursive);
  }
  std::filesystem::path operator/(const char* name) const { return folder_ / name; }

 private:
  project::Folder folder_;
};

}  // namespace ray
