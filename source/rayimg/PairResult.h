#pragma once

#include <array>
#include <optional>
#include <string>

#include "R2/ImageFile.h"
#include "grader/Cause.h"
#include "source/rayimg/Findings.h"

namespace ray::rayimg {

/// Two files to compare; one is empty where it has no partner.
struct Pair {
  std::string name;  // for tables
  std::string picture, reference;
};

/// What became of a pair, from the best to the worst.
enum class Outcome { equal, differs, fails, other_size, unpaired, unreadable };
inline constexpr std::array outcome_names{"equal",      "different", "beyond the limit",
                                          "other size", "unpaired",  "unreadable"};
constexpr const auto& NamesOf(Outcome) { return outcome_names; }

struct PairResult {
  Pair pair;
  Outcome outcome = Outcome::unpaired;
  std::string remark;             // what there is to say besides numbers; may be empty
  std::optional<Findings> found;  // none where there was nothing to measure
  std::optional<grade::Cause> cause;
  std::string figures;  // HTML, with -html
};

/// What measuring two pictures of one size has given.
PairResult ResultOf(const Pair& pair, const R2::DecodedImage& picture, const R2::DecodedImage& reference,
                    const Measurement& measured, const ImageOptions& options);

/// Reads two files and measures them. That one cannot be read is an outcome, not an error.
PairResult Compared(const Pair& pair, const ImageOptions& options);

/// In one sentence, with the share of the cause; empty where there is nothing to say.
std::string Summary(const PairResult& result);

}  // namespace ray::rayimg
