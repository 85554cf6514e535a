#pragma once

#include <filesystem>
#include <string>

namespace ray {

/// Where an interrupted render leaves its picture when another has the name: "out.partial.png" for "out.png".
std::string PartialName(const std::string& picture);

/// Whether something is there that an interrupted render must not replace: any file but one that says of itself that it
/// is the picture of an interrupted render.
bool IsFinishedPicture(const std::filesystem::path& file);

}  // namespace ray
