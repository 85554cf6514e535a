#pragma once

#include <span>

#include "source/accelerate/World.h"

namespace ray {

/// Marks the instances that are, to the bit, what an earlier one is: its shape in its place. Every ray that hits one
/// hits the other at the same t, and the lower primitive id wins, so that structures need not ask it; a scene may hold
/// 100,000 spheres in one place. Meshes are the same only where instances share one.
///   frames, motions   as World has them
void MarkRepetitions(std::span<Instance> instances, std::span<const R3::Transform> frames,
                     std::span<const R3::Vector> motions);

}  // namespace ray
