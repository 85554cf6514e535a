#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "source/parse/document/Mapping.h"
#include "source/scene/Camera.h"
#include "source/scene/Light.h"
#include "source/scene/Material.h"

/// Keys that scenes of several courses have, apart from those of objects.
namespace ray {

/// The kinds of light in YAML and JSON scenes: "point", "directional", "spot", "area", "sphere".
std::span<const std::string_view> LightNames();

/// Reads the keys of the light of that index, calling Finish: color, position and direction, and by their names in
/// .scn what else its kind has. Nothing gets weaker with distance unless ca, la and qa say so.
///   returns   null after a mistake, which is reported
std::unique_ptr<const Light> ReadLight(std::size_t name, Mapping& light);

/// Reads how a material blurs its reflections: the exponent of their lobe, and how many rays share one.
void ReadGloss(Mapping& material, Mapping::Names exponent, Mapping::Names samples, Material& read);

/// Takes `projection`, a name of cameras.def, from the mapping of a camera, and with it `fov`, a whole angle across in
/// degrees, or `viewWidth` of an orthographic one. Where none of these is given the camera stays what it is.
void ReadProjection(Mapping& mapping, Camera& camera);

}  // namespace ray
