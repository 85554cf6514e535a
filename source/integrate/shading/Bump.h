#pragma once

#include "R3/UvTangents.h"
#include "source/integrate/shading/ShadingPoint.h"

namespace ray {

/// The normal of a point whose material's bump texture dents the surface: of p + h n, h being the texture's luminance
/// times the material's height. The surface itself stays where it is.
///   p         its N is a unit shading normal on the viewer's side; where the outward side rises, the inner one sinks
///   uv        how texture coordinates run over the surface, in the world
///   returns   unit; p.N itself where tangents are parallel
///   source    Blinn, Simulation of wrinkled surfaces (1978), eq. 6 to first order in h, along any two tangents
R3::Vector Bumped(const ShadingPoint& p, const R3::UvTangents& uv);

/// The normal of a point whose material's normal map tilts it: a color c stands for 2 c - 1, of which red is along
/// growing u, green along growing v and blue along N.
///   p, uv     as for Bumped
///   returns   unit; p.N itself where texture coordinates do not run in two directions, or a black texel tells of none
///   source    Cohen, Olano, Manocha, Appearance-preserving simplification (1998), for normals in tangent space
R3::Vector NormalMapped(const ShadingPoint& p, const R3::UvTangents& uv);

}  // namespace ray
