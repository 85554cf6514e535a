#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/Project.h"

namespace ray {

/// The sample scenes in a folder of their own, to be written to.
class CopiedScenes {
 public:
  CopiedScenes() {
    std::string name = (std::filesystem::temp_directory_path() / "rayview-test-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    for (const char* part : {"hello.scn", "glass.scn", "empty.scn", "meshes", "textures"})
      std::filesystem::copy(project::Root() / "scenes" / part, folder_ / part,
                            std::filesystem::copy_options::recursive);
  }
  ~CopiedScenes() { std::filesystem::remove_all(folder_); }
  CopiedScenes(const CopiedScenes&) = delete;
  std::filesystem::path operator/(const char* name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

}  // namespace ray
