#include "source/app/report/Memory.h"

#include "source/app/Status.h"
#include "source/app/report/Resources.h"
#include "source/film/Film.h"
#include "source/text/Words.h"

namespace ray {
namespace {

constexpr double gib = 1024.0 * 1024.0 * 1024.0;

/// The memory of a structure while it is built. Measured: bvh of triangles 155 and of spheres 170 bytes, grid and
/// octree 190.
constexpr std::int64_t bytes_per_primitive = 200;
constexpr std::int64_t image_bytes_per_pixel = 3 * sizeof(float);
constexpr std::int64_t encoded_bytes_per_pixel =
    2 * 3 * sizeof(float);  // the encoder's rows or coefficients, and the file
// Measured on scenes/sphere.scn, 512 and 1024 pixels wide: 325 and 330 with our filter; 985 and 953 with Open Image
// Denoise, before each stream had its own best guides, which take 40.
constexpr std::int64_t denoise_bytes_per_pixel = 370, library_bytes_per_pixel = 1100;

/// Returns the memory per pixel while an image is filtered.
std::int64_t DenoiseBytesPerPixel(const RenderSettings& render) {
  if (!render.denoise) return 0;
  return render.denoiser == Denoiser::regression ? denoise_bytes_per_pixel : library_bytes_per_pixel;
}

/// Returns "1.25 GiB", or bytes if that would round to zero.
std::string InGib(std::int64_t bytes) {
  constexpr double least = 0.005;
  const double number = static_cast<double>(bytes) / gib;
  return number >= least || bytes == 0 ? Fixed(number, 2) + " GiB" : Counted(static_cast<std::uint64_t>(bytes), "byte");
}

}  // namespace

std::int64_t MemoryLimit(double gibibytes) {
  return gibibytes > 0 ? static_cast<std::int64_t>(gibibytes * gib) : MachineMemory() / 4 * 3;
}

std::int64_t ImageBytes(const RenderSettings& render, const FileOptions& files, bool saves) {
  const PixelRectangle part = MadeRegionOf(render);
  // Sums of blocks extend as far as the filter, and a checkpoint needs them twice more: copied, and encoded.
  const std::int64_t side = Film::block_side, reach = side + 2 * Filter(render.filter).Apron();
  const std::int64_t blocks = (part.Width() / side + 3) * (part.Height() / side + 3);
  const std::int64_t block =
      std::int64_t{sizeof(Film::Block)} + Film::parts * reach * reach * std::int64_t{sizeof(WeightedSum)};
  const std::int64_t copies = saves ? 3 : 1;
  // The image, one of each part for the error, layers and references.
  const auto images = static_cast<std::int64_t>(1 + Film::parts + files.layers.size() + files.reference.size());
  return copies * blocks * block +
         part.Area() * (images * image_bytes_per_pixel + encoded_bytes_per_pixel + DenoiseBytesPerPixel(render));
}

void CheckMemory(const World& world, std::int64_t image_bytes, double gibibytes) {
  const std::int64_t limit = MemoryLimit(gibibytes), held = PeakMemory(),
                     structure = bytes_per_primitive * world.Primitives();
  if (held + image_bytes + structure <= limit) return;
  throw UsageError("rendering may take " + InGib(held + image_bytes + structure) +
                   " of memory, more than the limit of " + InGib(limit) + ": the scene has " + InGib(held) +
                   ", its structure may need " + InGib(structure) + ", the image " + InGib(image_bytes) +
                   "; -memory sets another limit");
}

}  // namespace ray
