#pragma once

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "source/parse/Parse.h"
#include "tests/Sanitizers.h"

namespace ray {

/// A temporary folder for one test.
class Folder {
 public:
  Folder() {
    static std::atomic<int> count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("raypro_test_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(path_);
    path_ = std::filesystem::canonical(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& Path() const { return path_; }

  std::filesystem::path Write(const std::string& name, std::string_view bytes) const {
    const std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return file;
  }

 private:
  std::filesystem::path path_;
};

inline std::filesystem::path ProjectRoot() {
  const char* root = std::getenv("RAYPRO_ROOT");
  return root ? root : ".";
}

/// Parses a scene from text.
inline ParsedScene ParseText(std::string_view scene, const ParseOptions& options = {}) {
  const Folder folder;
  return Parse(folder.Write("scene.scn", scene), options);
}

/// Returns the report of a scene that must fail, without the folder's name; empty if it does not fail.
inline std::string ReportOf(const Folder& folder, const std::string& name, const ParseOptions& options = {}) {
  try {
    Parse(folder / name, options);
    return {};
  } catch (const SceneErrors& errors) {
    std::string report = errors.what();
    const std::string prefix = folder.Path().string() + "/";
    for (std::size_t i; (i = report.find(prefix)) != std::string::npos;) report.erase(i, prefix.size());
    return report;
  }
}

inline std::string ReportOf(std::string_view scene, const ParseOptions& options = {}) {
  const Folder folder;
  folder.Write("scene.scn", scene);
  return ReportOf(folder, "scene.scn", options);
}

inline bool Contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

using project::patience;

inline const std::string identity = " 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1\n";
inline const std::string red = "material 0 0 0  1 0 0  0 0 0  0 0 0  0 0 0  10 1 0\n";

}  // namespace ray
