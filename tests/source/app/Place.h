#pragma once

#include "tests/source/app/Program.h"

namespace ray::testing {

using List = std::vector<std::string>;

inline const std::string soft_scene =
    "camera 0 1 6  0 0 -1  0 1 0  0.3  0.1 100\nbox -1  -4 -1 -4  4 0 4\nsphere -1  0 0.8 0  0.8\n"
    "area_light 9 9 9  2 4 2  -1 -2 -1  1  0 0 1\n";

/// A folder with a scene, and small images of it.
struct Place : SceneFolder {
  explicit Place(const std::string& text = soft_scene) : SceneFolder(text) {}
  /// Runs the program with options for a small image and the given words.
  Finished Run(const std::string& image, const List& more) const {
    return RunProgram(With({Scene(), *this / image, "-width", "40", "-height", "30", "-quiet"}, more));
  }
};

}  // namespace ray::testing
