#include "source/app/options/BudgetWords.h"

#include <array>
#include <utility>

#include "source/text/Number.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

/// Returns the number before a suffix of `word`, if it is a number above 0.
std::optional<double> Before(const std::string& suffix, const std::string& word) {
  if (!word.ends_with(suffix)) return {};
  const auto number = ParseNumber(word.substr(0, word.size() - suffix.size()));
  if (number.problem || !(number.value > 0)) return {};
  return number.value;
}

constexpr std::array<std::pair<const char*, double>, 4> duration_units{
    {{"s", 1.0}, {"m", 60.0}, {"h", 3600.0}, {"", 1.0}}};
constexpr std::array<std::pair<const char*, ErrorUnit>, 4> error_units{
    {{"%", ErrorUnit::relative}, {"dB", ErrorUnit::decibel}, {"lin", ErrorUnit::linear}, {"", ErrorUnit::display}}};

}  // namespace

std::optional<double> ReadDuration(const std::string& word) {
  for (const auto& [suffix, seconds] : duration_units)
    if (const auto number = Before(suffix, word)) return *number * seconds;
  return {};
}

std::string ShowDuration(const double& seconds) { return seconds > 0 ? ToText(seconds) + "s" : ""; }

std::optional<std::optional<ErrorTarget>> ReadErrorTarget(const std::string& word) {
  for (const auto& [suffix, unit] : error_units)
    if (const auto number = Before(suffix, word)) return ErrorTarget{*number, unit};
  return {};
}

std::string ShowErrorTarget(const std::optional<ErrorTarget>& target) {
  if (!target) return "";
  for (const auto& [suffix, unit] : error_units)
    if (unit == target->unit) return ToText(target->value) + suffix;
  return "";
}

std::optional<std::optional<ImagePart>> ReadPart(const std::string& word) {
  const std::size_t slash = word.find('/');
  if (slash == std::string::npos) return {};
  const auto index = ParseWhole(word.substr(0, slash)), of = ParseWhole(word.substr(slash + 1));
  if (index.problem || of.problem || index.value < 1 || index.value > of.value || of.value > most_image_parts)
    return {};
  return ImagePart{static_cast<int>(index.value), static_cast<int>(of.value)};
}

std::string ShowPart(const std::optional<ImagePart>& part) {
  return part ? std::to_string(part->index) + "/" + std::to_string(part->of) : "";
}

bool ReadSamples(const std::string& word, RenderSettings& render) {
  constexpr int most_apart = 16;  // pixels per traced pixel
  for (int apart = 2; apart <= most_apart; apart *= 2) {
    if (word != "1/" + std::to_string(apart)) continue;
    render.samples = 1;
    render.places = BlockOrder::places / apart;
    return true;
  }
  const auto whole = ParseWhole(word);
  if (whole.problem || whole.value < 1 || !std::in_range<int>(whole.value)) return false;
  render.samples = static_cast<int>(whole.value);
  render.places = BlockOrder::places;
  return true;
}

std::string ShowSamples(const RenderSettings& render) {
  return IsSubsampled(render) ? "1/" + std::to_string(BlockOrder::places / render.places)
                              : std::to_string(render.samples);
}

std::optional<int> ReadLightCount(const std::string& word) {
  if (word == "auto") return -1;
  if (word == "all") return 0;
  if (word == "one") return 1;
  const auto whole = ParseWhole(word);
  if (whole.problem || whole.value < 1 || !std::in_range<int>(whole.value)) return {};
  return static_cast<int>(whole.value);
}

std::string ShowLightCount(const int& count) {
  return count < 0 ? "auto" : count == 0 ? "all" : count == 1 ? "one" : std::to_string(count);
}

}  // namespace ray
