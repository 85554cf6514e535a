#pragma once

#include <array>
#include <optional>
#include <string>

#include "R2/ImageFile.h"
#include "grader/Cause.h"
#include "rayimg/Findings.h"

namespace ray::rayimg {

/// Two files to compare; one is empty if it has no partner.
struct Pair {
  std::string name;  // for tables
  std::string image, reference;
};

/// The result of a pair, from best to worst.
enum class Outcome { equal, differs, fails, other_size, unpaired, unreadable };
inline constexpr std::array outcome_names{"equal",      "different", "beyond the limit",
                                          "other size", "unpaired",  "unreadable"};
constexpr const auto& NamesOf(Outcome) { return outcome_names; }

struct PairResult {
  Pair pair;
  Outcome outcome = Outcome::unpaired;
  std::string remark;             // remarks in addition to numbers; may be empty
  std::optional<Findings> found;  // std::nullopt if nothing could be measured
  std::optional<grade::Cause> cause;
  std::string figures;  // HTML, with -html
};

/// Returns the result of measuring two images of the same size.
PairResult ResultOf(const Pair& pair, const R2::DecodedImage& decoded, const R2::DecodedImage& reference,
                    const Measurement& measured, const ImageOptions& options);

/// Reads two files and measures them. An unreadable file is an outcome, not an error.
PairResult Compared(const Pair& pair, const ImageOptions& options);

/// Returns a one-sentence summary, with the share of the cause; may be empty.
std::string Summary(const PairResult& result);

}  // namespace ray::rayimg
