#pragma once

#include <string>
#include <vector>

#include "source/parse/SceneError.h"

namespace ray {

/// The mistakes and remarks collected while a scene is read.
class Report {
 public:
  /// Throws SceneErrors when there are too many to go on.
  void Error(SceneError error);
  /// One line, which is kept once however often it is said; beyond a hundred they are counted only.
  void Warn(const std::string& place, const std::string& message);

  /// Throws SceneErrors if there was any.
  void ThrowErrors();
  std::vector<std::string> Warnings() const;

 private:
  std::vector<SceneError> errors_;
  std::vector<std::string> warnings_;
  std::size_t warnings_left_out_ = 0;
};

}  // namespace ray
