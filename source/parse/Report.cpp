#include "source/parse/Report.h"

#include <algorithm>
#include <utility>

namespace ray {
namespace {

constexpr std::size_t max_warnings = 100;

}  // namespace

void Report::Error(SceneError error) {
  errors_.push_back(std::move(error));
  if (errors_.size() >= SceneErrors::max_kept) ThrowErrors();
}

void Report::Warn(const std::string& place, const std::string& message) {
  std::string line = place + ": warning: " + message;
  // A file that is read twice, for two uses, says the same twice.
  if (std::ranges::find(warnings_, line) != warnings_.end()) return;
  if (warnings_.size() < max_warnings)
    warnings_.push_back(std::move(line));
  else
    ++warnings_left_out_;
}

void Report::ThrowErrors() {
  if (!errors_.empty()) throw SceneErrors(std::exchange(errors_, {}));
}

std::vector<std::string> Report::Warnings() const {
  std::vector<std::string> all = warnings_;
  if (warnings_left_out_ > 0) all.push_back("and " + std::to_string(warnings_left_out_) + " more warnings");
  return all;
}

}  // namespace ray
