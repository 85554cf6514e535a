#pragma once

#include "source/parse/document/Mapping.h"
#include "source/scene/Material.h"

namespace ray {

/// Reads how a material blurs its reflections: the exponent of their lobe, and how many rays share one.
void ReadGloss(Mapping& material, Mapping::Names exponent, Mapping::Names samples, Material& read);

}  // namespace ray
