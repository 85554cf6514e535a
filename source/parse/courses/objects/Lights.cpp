#include "source/parse/courses/objects/Lights.h"

#include <algorithm>
#include <array>
#include <vector>

namespace ray {
namespace {

constexpr std::array<std::string_view, 5> light_names{"point", "directional", "spot", "area", "sphere"};
constexpr std::array light_kinds{"point_light", "dir_light", "spot_light", "area_light", "sphere_light"};

/// The numbers of a .scn line, some of which are together in one key here.
struct LightNumbers {
  R2::Color color;
  R3::Vector position, direction;

  std::optional<double> Of(std::string_view argument) const {
    const std::array<std::pair<std::string_view, double>, 9> known{{{"r", color.r},
                                                                    {"g", color.g},
                                                                    {"b", color.b},
                                                                    {"px", position.x},
                                                                    {"py", position.y},
                                                                    {"pz", position.z},
                                                                    {"dx", direction.x},
                                                                    {"dy", direction.y},
                                                                    {"dz", direction.z}}};
    for (const auto& [key, value] : known)
      if (key == argument) return value;
    return {};
  }
};

bool HasArgument(const LightKind& kind, std::string_view argument) {
  return std::any_of(kind.arguments.begin(), kind.arguments.end(),
                     [&](const R3::Argument& a) { return a.name == argument; });
}

}  // namespace

std::span<const std::string_view> LightNames() { return light_names; }

std::unique_ptr<const Light> ReadLight(std::size_t name, Mapping& light) {
  const LightKind& kind = *FindLightKind(light_kinds[name]);
  LightNumbers numbers;
  numbers.color = light.NeedColor({"color", "colour"});
  if (HasArgument(kind, "px")) numbers.position = light.NeedVector({"position"});
  if (HasArgument(kind, "dx")) numbers.direction = light.NeedVector({"direction"});
  std::vector<double> values;
  for (const R3::Argument& argument : kind.arguments) {
    const std::string_view word = argument.name;
    const Range range = argument.may_be_negative ? any_number : not_negative;
    if (const auto known = numbers.Of(word))
      values.push_back(*known);
    else if (word == "ca" || word == "la" || word == "qa")
      values.push_back(light.Number({word}, range, word == "ca" ? 1 : 0));
    else
      values.push_back(light.NeedNumber({word}, range));
  }
  if (!light.FinishedWell()) return nullptr;
  try {
    return kind.make(values);
  } catch (const R3::ArgumentError& error) {
    light.Reporter().Error(light.What(), std::string(": ") + error.what());
    return nullptr;
  }
}

}  // namespace ray
