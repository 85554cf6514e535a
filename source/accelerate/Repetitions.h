#pragma once

#include <span>

#include "source/accelerate/World.h"

namespace ray {

/// Marks the instances that are bit-identical to another, with the same shape in the same place, and hidden by it: one
/// that emits hides those that do not, then the first hides the others (see Contact.h). Every ray that hits one hits
/// the other at the same t, so structures need not test it; a scene may contain 100,000 spheres in one place. Meshes
/// are identical only if the instances share one.
///   frames, motions   as in World
void MarkRepetitions(std::span<Instance> instances, std::span<const R3::Transform> frames,
                     std::span<const R3::Vector> motions);

}  // namespace ray
