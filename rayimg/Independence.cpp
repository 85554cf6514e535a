#include "rayimg/Independence.h"

#include <filesystem>
#include <iterator>
#include <sstream>

#include "source/text/Quoting.h"

namespace ray::rayimg {

std::string Setting(const R2::ImageSettings& settings, const std::string& key) {
  const auto found = settings.find(key);
  return found == settings.end() ? "" : found->second;
}

bool Agree(const R2::ImageSettings& a, const R2::ImageSettings& b, const std::string& key) {
  return !Setting(a, key).empty() && Setting(a, key) == Setting(b, key);
}

std::set<std::string> Seeds(const R2::ImageSettings& settings) {
  std::istringstream words(Setting(settings, "seed"));
  return {std::istream_iterator<std::string>(words), {}};
}

std::optional<std::string> WhyDependent(const std::string& a_name, const R2::ImageSettings& a,
                                        const std::string& b_name, const R2::ImageSettings& b) {
  const std::string both = Quoted(a_name) + " and " + Quoted(b_name) + " are ";
  std::error_code ignored;
  if (std::filesystem::equivalent(a_name, b_name, ignored)) return both + "the same file";
  if (!Agree(a, b, "scene_hash") && !Agree(a, b, "command")) return {};
  const std::set<std::string> others = Seeds(b);
  for (const std::string& seed : Seeds(a))
    if (others.contains(seed)) return both + "not independent: both have seed " + Quoted(seed);
  return {};
}

}  // namespace ray::rayimg
