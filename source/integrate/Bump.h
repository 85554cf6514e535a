#pragma once

#include "source/integrate/TraceState.h"

namespace ray {

/// The normal of a surface that its material's bump texture dents: of p + h n, h being the texture's luminance times
/// the material's height, with which the surface itself stays where it is.
///   N         unit shading normal on the viewer's side; the outward side rises with h, so the inner one sinks
///   returns   unit; N itself where the surface is too narrow to tell which way its texture runs
///   source    Blinn, Simulation of wrinkled surfaces (1978), eq. 6 to first order in h. How texture coordinates run
///             over the surface is found by asking the shape for them a little to each side, so no shape need tell
R3::Vector Bumped(const World& world, const R3::Ray& ray, const WorldHit& hit, const R3::Intersection& at,
                  const Material& material, const R3::Vector& N, bool entering);

/// The normal of a surface that its material's normal map tilts: a color c stands for 2 c - 1, of which red is along
/// growing u, green along growing v and blue along N.
///   N         unit shading normal on the viewer's side
///   returns   unit; N itself where texture coordinates do not run in two directions, or a black texel tells of none
///   source    Cohen, Olano, Manocha, Appearance-preserving simplification (1998), for normals in tangent space, which
///             is found as for Bumped
R3::Vector NormalMapped(const World& world, const R3::Ray& ray, const WorldHit& hit, const R3::Intersection& at,
                        const Material& material, const R3::Vector& N, bool entering);

}  // namespace ray
