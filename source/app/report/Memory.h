#pragma once

#include <cstdint>

#include "source/accelerate/World.h"
#include "source/app/options/Options.h"

namespace ray {

/// The bytes that the program may take, for the GiB that -memory gives; three quarters of this machine's memory for 0.
std::int64_t MemoryLimit(double gibibytes);

/// Before anything is built or rendered, throws UsageError where what the process holds already, the largest that an
/// acceleration structure may take, and the picture with its layers and references together exceed the limit.
void CheckMemory(const World& world, const Options& options);

/// Bytes that the samples, the picture and what is made of it take: an estimate, above what is measured.
std::int64_t PictureBytes(const Options& options);

}  // namespace ray
