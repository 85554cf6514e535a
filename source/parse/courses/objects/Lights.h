#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "source/parse/document/Mapping.h"
#include "source/scene/Light.h"

namespace ray {

/// The kinds of light in YAML and JSON scenes: "point", "directional", "spot", "area", "sphere".
std::span<const std::string_view> LightNames();

/// Reads the keys of the light of that index, calling Finish: color, position and direction, and by their names in
/// .scn what else its kind has. Nothing gets weaker with distance unless ca, la and qa say so.
///   returns   null after a mistake, which is reported
std::unique_ptr<const Light> ReadLight(std::size_t name, Mapping& light);

}  // namespace ray
