#pragma once

#include "R3/UvTangents.h"
#include "source/integrate/shading/ShadingPoint.h"

namespace ray {

/// Returns the normal of a point whose material's bump texture displaces the surface: that of p + h n, with h the
/// texture's luminance times the material's height. The surface itself is unchanged.
///   p         its N is a unit shading normal on the viewer's side; where the outward side rises, the inner one sinks
///   uv        the tangents of texture coordinates on the surface, in the world
///   returns   unit; p.N itself if tangents are parallel
///   source    Blinn, Simulation of wrinkled surfaces (1978), eq. 6 to first order in h, along any two tangents
R3::Vector Bumped(const ShadingPoint& p, const R3::UvTangents& uv);

/// Returns the normal of a point whose material's normal map tilts it. A color c represents 2 c - 1, with red along
/// increasing u, green along increasing v and blue along N.
///   p, uv     as for Bumped
///   returns   unit; p.N itself if texture coordinates do not span two directions, or for a black texel
///   source    Cohen, Olano, Manocha, Appearance-preserving simplification (1998), for normals in tangent space
R3::Vector NormalMapped(const ShadingPoint& p, const R3::UvTangents& uv);

}  // namespace ray
