#pragma once

#include <string>

#include "source/rayimg/Options.h"

/// The commands of rayimg. Each gives the exit status, and throws UsageError, SceneErrors (for files that are missing
/// or no pictures) and OutputError. `command_line` is what was typed, to be kept in pictures that are written.
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
