#pragma once

#include <map>
#include <optional>
#include <string>

#include "source/scene/Camera.h"

namespace ray {

/// The camera as a line of a .scn file that reads back as the same camera to the bit:
///     camera ex ey ez  tx ty tz  ux uy uz  xfov  near far [view aspect shift_x shift_y]
std::string CameraLine(const Camera& camera);
/// Nothing when it is no such line.
std::optional<Camera> ReadCameraLine(const std::string& line);

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
