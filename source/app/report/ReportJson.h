#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "source/app/report/RunStats.h"

namespace ray {

/// Returns the text of -report: one JSON object with the keys of ReportFields.
std::string ReportJson(const RunStats& stats);

/// Returns its part `settings`.
nlohmann::ordered_json SettingsJson(const RunStats& stats);

}  // namespace ray
