#pragma once

#include <string>

#include "source/app/options/RenderOptions.h"

namespace ray {

/// The raypro command that makes the picture of these options, but for a camera that was moved by hand: scene, picture,
/// and every option that was typed or has another value than raypro's default. Those that no byte of a picture depends
/// on are left out: how it is reported, how many threads work, and in how many runs it is made.
std::string RayproCommand(const RenderOptions& options);

}  // namespace ray
