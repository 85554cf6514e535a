#pragma once

#include <span>

namespace ray {

/// A key of the JSON object that -report writes.
struct ReportField {
  const char* name;
  const char* meaning;
};

/// Returns all top-level keys of a report, in order. The manual page and docs/options.md are made from them.
std::span<const ReportField> ReportFields();

}  // namespace ray
