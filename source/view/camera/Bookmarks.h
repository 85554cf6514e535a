#pragma once

#include <map>
#include <optional>
#include <string>

#include "source/scene/Camera.h"

namespace ray {

/// Cameras under the digits 1 to 9, which are kept in a file next to the scene: lines of a digit and a camera line.
class Bookmarks {
 public:
  /// Reads those in the file; "-", standard input, has no such file.
  explicit Bookmarks(const std::string& scene);

  /// Adds the cameras that another window has saved in the file since; others stay.
  void ReadAgain();
  std::optional<Camera> Find(int digit) const;
  void Set(int digit, const Camera& camera) { cameras_.insert_or_assign(digit, camera); }
  /// Returns the content for the file.
  std::string Text() const;
  /// Empty if there is none.
  const std::string& File() const { return file_; }

 private:
  std::string file_;
  std::map<int, Camera> cameras_;
};

}  // namespace ray
