#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "source/app/report/RunStats.h"

namespace ray {

/// What -report writes: one JSON object with the keys of ReportFields.
std::string ReportJson(const RunStats& stats);

/// The part of it called settings.
nlohmann::ordered_json SettingsJson(const RunStats& stats);

}  // namespace ray
