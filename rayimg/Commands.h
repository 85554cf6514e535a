#pragma once

#include <string>

#include "rayimg/Options.h"

/// The commands of rayimg. Each returns the exit status, and throws UsageError, SceneErrors (for files that are missing
/// or not images) and OutputError. `command_line` is the command as typed, which is stored in written images.
namespace ray::rayimg {

int Diff(const ImageOptions& options, const std::string& command_line);
int Info(const ImageOptions& options, const std::string& command_line);
int Extract(const ImageOptions& options, const std::string& command_line);
int Convert(const ImageOptions& options, const std::string& command_line);
int Resize(const ImageOptions& options, const std::string& command_line);
int Crop(const ImageOptions& options, const std::string& command_line);
int SideBySide(const ImageOptions& options, const std::string& command_line);
int ContactSheet(const ImageOptions& options, const std::string& command_line);
int Merge(const ImageOptions& options, const std::string& command_line);
int Movie(const ImageOptions& options, const std::string& command_line);

}  // namespace ray::rayimg
