#pragma once

#include <vector>

#include "grader/Mistake.h"

namespace ray::grade {

// The tables of all mistakes, in the order in which they are tried: among mistakes with the same image, the first one
// is named first.

using MistakeTable = std::vector<Mistake>;

extern const MistakeTable shading_mistakes;   // the terms at a surface
extern const MistakeTable lights_mistakes;    // lights, their attenuation and their shadows
extern const MistakeTable rays_mistakes;      // reflected and refracted rays
extern const MistakeTable geometry_mistakes;  // normals, transforms and shapes
extern const MistakeTable camera_mistakes;    // the camera
extern const MistakeTable left_out_mistakes;  // omitted parts of a scene
extern const MistakeTable image_mistakes;     // the finished image

}  // namespace ray::grade
