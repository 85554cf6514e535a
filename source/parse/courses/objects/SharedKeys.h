#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "source/parse/document/Mapping.h"
#include "source/scene/Camera.h"
#include "source/scene/Light.h"
#include "source/scene/Material.h"

/// Keys shared by the scenes of several courses, except those of objects.
namespace ray {

/// Returns the kinds of light in YAML and JSON scenes: "point", "directional", "spot", "area", "sphere".
std::span<const std::string_view> LightNames();

/// Reads the keys of the light with that index, calling Finish: color, position and direction, and the other arguments
/// of its kind by their names in .scn. There is no attenuation unless ca, la and qa are given.
///   returns   null after a mistake, which is reported
std::unique_ptr<const Light> ReadLight(std::size_t name, Mapping& light);

/// Reads the blur of a material's reflections: the exponent of their lobe, and the number of rays per reflection.
void ReadGloss(Mapping& material, Mapping::Names exponent, Mapping::Names samples, Material& read);

/// Reads `projection`, a name of cameras.def, from the mapping of a camera, and `fov`, the whole horizontal angle in
/// degrees, or `viewWidth` for an orthographic camera. If none of these is given, the camera is unchanged.
void ReadProjection(Mapping& mapping, Camera& camera);

}  // namespace ray
