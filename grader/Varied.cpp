#include <span>

#include "grader/Grader.h"
#include "source/parse/Text.h"
#include "source/text/Hash.h"
#include "source/text/Number.h"
#include "source/text/NumberText.h"
#include "source/text/Quoting.h"

namespace ray::grade {
namespace {

/// Returns a number in [0, 1) that depends on a seed, a scene and a place in it.
double Chosen(std::uint64_t seed, const std::string& scene, std::uint64_t place) {
  Hash hash;
  hash.Add(std::span(reinterpret_cast<const unsigned char*>(scene.data()), scene.size()));
  hash.AddWord(seed);
  hash.AddWord(place);
  hash.AddWord(seed ^ place);
  constexpr double two_to_53 = 9007199254740992.0;
  return static_cast<double>(hash.Value() >> 11) / two_to_53;
}

/// Returns the text with a number for each {a..b}.
std::string WithNumbers(std::string text, const SuiteScene& scene, std::uint64_t seed, std::uint64_t& place) {
  for (std::size_t begin = text.find('{'); begin != std::string::npos; begin = text.find('{', begin + 1)) {
    const std::size_t dots = text.find("..", begin), end = text.find('}', begin);
    if (dots == std::string::npos || end == std::string::npos || dots > end) continue;
    const auto low = ParseNumber(text.substr(begin + 1, dots - begin - 1));
    const auto high = ParseNumber(text.substr(dots + 2, end - dots - 2));
    if (low.problem || high.problem) continue;
    const double value = low.value + Chosen(seed, scene.name, place++) * (high.value - low.value);
    text.replace(begin, end + 1 - begin, Fixed(value, 4));
  }
  return text;
}

SceneError NotThereOnce(const SuiteScene& scene, const std::string& what, SceneError at) {
  if (at.file.empty()) at.file = scene.file;
  at.message = "the text to be varied, " + Quoted(what) + ", must be in " + QuotedPath(scene.file) + " exactly once";
  return at;
}

}  // namespace

std::string Varied(const std::string& text, const SuiteScene& scene, std::uint64_t seed) {
  std::string varied = text;
  std::uint64_t place = 0;
  for (const auto& [what, with, at_suite] : scene.vary) {
    const std::size_t at = varied.find(what);
    if (at == std::string::npos || varied.find(what, at + 1) != std::string::npos)
      throw SceneErrors({NotThereOnce(scene, what, at_suite)});
    varied.replace(at, what.size(), WithNumbers(with, scene, seed, place));
  }
  return varied;
}

}  // namespace ray::grade
