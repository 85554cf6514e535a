#pragma once

#include <vector>

#include "grader/Mistake.h"

namespace ray::grade {

// The tables of all mistakes, in the order in which they are tried: of those that make the same image, the first is
// named first.

using MistakeTable = std::vector<Mistake>;

extern const MistakeTable shading_mistakes;   // what is added up at a surface
extern const MistakeTable lights_mistakes;    // lights, their attenuation and their shadows
extern const MistakeTable rays_mistakes;      // reflected and refracted rays
extern const MistakeTable geometry_mistakes;  // normals, transforms and shapes
extern const MistakeTable camera_mistakes;    // the camera
extern const MistakeTable left_out_mistakes;  // parts of a scene that are left out
extern const MistakeTable image_mistakes;     // the finished image

}  // namespace ray::grade
