#pragma once

#include <map>
#include <optional>
#include <string>

#include "source/scene/Camera.h"

namespace ray {

/// Cameras under the digits 1 to 9, kept in a file beside the scene: lines of a digit and a camera line.
class Bookmarks {
 public:
  explicit Bookmarks(const std::string& scene);

  std::optional<Camera> Find(int digit) const;
  /// Also into the file; false when it cannot be written, and the bookmark lasts as long as the program.
  bool Keep(int digit, const Camera& camera);
  const std::string& File() const { return file_; }

 private:
  std::string file_;
  std::map<int, Camera> cameras_;
};

}  // namespace ray
