#pragma once

#include <optional>
#include <string>

#include "source/app/options/Options.h"

namespace ray {

/// How the render that wrote the report shared its samples out; nothing without -replay. Throws SceneErrors when the
/// file is no report of ours, UsageError when it tells of another picture: `scene_hash` or an option that chooses what
/// the picture shows differs.
std::optional<Replay> ReadReplay(const Options& options, const std::string& scene_hash);

}  // namespace ray
