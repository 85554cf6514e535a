#pragma once

#include <string>

#include "R3/Mesh.h"

namespace ray {

/// A mesh as a Wavefront OBJ file. Read again, smooth if it is smooth, it is the same mesh to the bit.
std::string ObjText(const R3::Mesh& mesh);

}  // namespace ray
