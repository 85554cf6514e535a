#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "source/app/report/RunStats.h"

namespace ray {

/// A key of the JSON object that -report writes.
struct ReportField {
  const char* name;
  const char* meaning;
};

/// Returns all top-level keys of a report, in order. The manual page and docs/options.md are made from them.
std::span<const ReportField> ReportFields();

/// Returns the text of -report: one JSON object with the keys of ReportFields.
std::string ReportJson(const RunStats& stats);

/// Returns its part `settings`.
nlohmann::ordered_json SettingsJson(const RunStats& stats);

}  // namespace ray
