#pragma once

#include <optional>

#include "source/app/report/RunStats.h"

namespace ray {

/// Returns the sample allocation of the render that wrote the report; std::nullopt without -replay. Throws SceneErrors
/// if the file is not a report of ours, UsageError if it belongs to another image than that of this run: the scene, or
/// an option that affects the content of the image, differs.
std::optional<Replay> ReadReplay(const RunStats& run);

}  // namespace ray
