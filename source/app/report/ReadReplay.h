#pragma once

#include <optional>
#include <string>

#include "source/app/report/RunStats.h"

namespace ray {

/// How the render that wrote the report shared its samples out; nothing without -replay. Throws SceneErrors when the
/// file is no report of ours, UsageError when it tells of another picture than the one of this run: the scene, or an
/// option that chooses what the picture shows, differs.
std::optional<Replay> ReadReplay(const RunStats& run);

}  // namespace ray
