#include "fuzz/Fuzz.h"
#include "source/render/Render.h"
#include "source/render/RenderState.h"
#include "source/text/Hash.h"

/// The checksum is put right, since no mutation would.
int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  ray::RenderSettings settings;
  settings.width = settings.height = 16;
  settings.samples = 8;
  std::vector<unsigned char> bytes(data, data + size);
  ray::Hash hash;
  hash.Add(bytes);
  for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<unsigned char>(hash.Value() >> 8 * i));
  const ray::Film film = ray::EmptyFilmOf(settings);
  try {
    const ray::RenderState state = ray::DecodedState(bytes, "scene 1\n", film);
    ray::CheckPlan(state, settings);
    ray::CheckState(state, film, settings);
  } catch (const ray::CheckpointError&) {
  }
  return 0;
}
