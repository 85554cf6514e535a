#pragma once

#include <cstdint>

#include "source/accelerate/World.h"
#include "source/app/options/RenderOptions.h"

namespace ray {

/// The bytes that the program may take, for the GiB that -memory gives; three quarters of this machine's memory for 0.
std::int64_t MemoryLimit(double gibibytes);

/// Before anything is built or rendered, throws UsageError where what the process holds already, the largest that an
/// acceleration structure may take, and the picture with its layers and references together exceed the limit.
///   picture     its PictureBytes
///   gibibytes   the limit, as for MemoryLimit
void CheckMemory(const World& world, std::int64_t picture, double gibibytes);

/// Bytes that the samples, the picture and what is made of it take: an estimate, above what is measured.
///   saves   checkpoints, while it renders
std::int64_t PictureBytes(const RenderSettings& render, const FileOptions& files, bool saves);

}  // namespace ray
