#pragma once

#include <string>

#include "source/app/options/RenderOptions.h"

namespace ray {

/// Returns the raypro command that reproduces the image of these options, except for a camera that was moved by hand:
/// scene, image, and every option that was typed or differs from raypro's default. Options that affect no byte of the
/// image are omitted: reports, threads, and the division into several runs.
std::string RayproCommand(const RenderOptions& options);

}  // namespace ray
