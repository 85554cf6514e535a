#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace ray {

/// The exit statuses, for scripts.
namespace status {
inline constexpr int done = 0;
inline constexpr int failed = 1;  // while rendering
inline constexpr int wrong_arguments = 2;
inline constexpr int bad_scene = 3;  // or a missing one
inline constexpr int cannot_write = 4;
inline constexpr int killed_by = 128;  // plus the number of the signal: 130 and 143; the image so far is saved
}  // namespace status

/// A mistake on the command line; what() contains the option, the value and the rule.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An error about a file that cannot be written; what() contains its name and the reason.
struct OutputError : std::runtime_error {
  explicit OutputError(const std::string& what, std::string kept = {})
      : std::runtime_error(what), kept_as(std::move(kept)) {}
  std::string kept_as;  // the file that contains its bytes instead; empty for none
};

}  // namespace ray
