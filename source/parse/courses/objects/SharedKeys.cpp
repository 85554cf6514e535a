#include "source/parse/courses/objects/SharedKeys.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "source/text/Quoting.h"

namespace ray {
namespace {

constexpr std::array<std::string_view, 5> light_names{"point", "directional", "spot", "area", "sphere"};
constexpr std::array light_kinds{"point_light", "dir_light", "spot_light", "area_light", "sphere_light"};

const CameraKind& KindOf(Mapping& mapping, const Camera& camera) {
  const auto name = mapping.Find({"projection"});
  const auto which = name ? name->Choice(CameraKindNames(), "projections") : std::nullopt;
  return which ? *CameraKinds()[*which] : *camera.kind;
}

/// Reads a number that only some kinds of camera have.
void ReadExtent(Mapping& mapping, const char* key, bool is_known, Camera& camera) {
  const auto field = mapping.Find({key});
  if (!field) return;
  const std::string what = std::string("projection ") + camera.kind->name;
  if (!is_known) return field->Error("has no meaning with " + what);
  const auto extent = field->Number();
  if (extent && !IsExtent(*camera.kind, *extent))
    return field->Error("must be " + std::string(RangeOfExtent(*camera.kind)) + " with " + what + ", got " +
                        Escaped(field->What().scalar));
  camera.extent = extent.value_or(0);
}

}  // namespace

std::span<const std::string_view> LightNames() { return light_names; }

std::unique_ptr<const Light> ReadLight(std::size_t name, Mapping& light) {
  const LightKind& kind = *FindLightKind(light_kinds[name]);
  const auto has = [&](std::string_view argument) {
    return std::ranges::any_of(kind.arguments, [&](const R3::Argument& a) { return a.name == argument; });
  };
  const R2::Color color = light.NeedColor({"color", "colour"});
  const R3::Vector position = has("px") ? light.NeedVector({"position"}) : R3::Vector{};
  const R3::Vector direction = has("dx") ? light.NeedVector({"direction"}) : R3::Vector{};
  const std::map<std::string_view, double> in_one_key{{"r", color.r},      {"g", color.g},      {"b", color.b},
                                                      {"px", position.x},  {"py", position.y},  {"pz", position.z},
                                                      {"dx", direction.x}, {"dy", direction.y}, {"dz", direction.z}};
  std::vector<double> values;
  for (const R3::Argument& argument : kind.arguments) {
    const std::string_view word = argument.name;
    const Range range = argument.may_be_negative ? any_number : not_negative;
    if (const auto known = in_one_key.find(word); known != in_one_key.end())
      values.push_back(known->second);
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

void ReadGloss(Mapping& material, Mapping::Names exponent, Mapping::Names samples, Material& read) {
  const auto gloss = material.Find(exponent), rays = material.Find(samples);
  if (rays && !gloss) return rays->Error("goes with " + std::string(*exponent.begin()) + ", which is missing");
  if (!gloss) return;
  read.gloss = gloss->Number(positive).value_or(0);
  if (rays) read.gloss_samples = static_cast<int>(rays->Whole(1, Material::most_gloss_samples).value_or(1));
}

void ReadProjection(Mapping& mapping, Camera& camera) {
  camera.kind = &KindOf(mapping, camera);
  ReadExtent(mapping, "fov", camera.kind->extent == CameraExtent::angle && !camera.IsPinhole(), camera);
  ReadExtent(mapping, "viewWidth", camera.kind->extent == CameraExtent::width, camera);
}

}  // namespace ray
