#pragma once

#include <string>
#include <string_view>

#include "source/parse/Parse.h"
#include "tests/Folder.h"
#include "tests/Sanitizers.h"

namespace ray {

using project::Folder;

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

inline std::string Repeated(const std::string& text, std::size_t times) {
  std::string all;
  all.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

using project::patience;

inline const std::string identity = " 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1\n";
inline const std::string red = "material 0 0 0  1 0 0  0 0 0  0 0 0  0 0 0  10 1 0\n";

}  // namespace ray
