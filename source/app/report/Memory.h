#pragma once

#include <cstdint>

#include "source/accelerate/World.h"
#include "source/app/options/RenderOptions.h"

namespace ray {

/// Returns the bytes that the program may use, for the GiB given by -memory; three quarters of this machine's memory
/// for 0.
std::int64_t MemoryLimit(double gibibytes);

/// Before anything is built or rendered, throws UsageError if the current memory of the process, the maximum of an
/// acceleration structure, and the image with its layers and references together exceed the limit.
///   image_bytes   its ImageBytes
///   gibibytes     the limit, as for MemoryLimit
void CheckMemory(const World& world, std::int64_t image_bytes, double gibibytes);

/// Returns the bytes of the samples, the image and everything derived from it: an estimate, above the measured values.
///   saves   whether checkpoints are written during the render
std::int64_t ImageBytes(const RenderSettings& render, const FileOptions& files, bool saves);

}  // namespace ray
