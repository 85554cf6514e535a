#include <algorithm>
#include <cstring>
#include <string_view>

#include "fuzz/Fuzz.h"
#include "source/render/Render.h"
#include "source/render/RenderState.h"
#include "source/text/Hash.h"

namespace {

/// The identity that a checkpoint holds: behind its first line, after its length.
std::string IdentityIn(fuzz::Bytes bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t begin = std::min(text.find('\n'), text.size() - 1) + 1;
  std::uint64_t length = 0;
  if (text.size() - begin < sizeof length) return {};
  std::memcpy(&length, text.data() + begin, sizeof length);
  return std::string(text.substr(begin + sizeof length).substr(0, length));
}

}  // namespace

/// The checksum is put right and the identity taken for ours, since no mutation would make them so.
int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  ray::RenderSettings settings;
  settings.width = settings.height = 16;
  settings.samples = 8;
  if (size == 0) return 0;
  std::vector<unsigned char> bytes(data, data + size);
  ray::Hash hash;
  hash.Add(bytes);
  for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<unsigned char>(hash.Value() >> 8 * i));
  const ray::Film film = ray::EmptyFilmOf(settings);
  try {
    const ray::RenderState state = ray::DecodedState(bytes, IdentityIn({data, size}), film);
    ray::CheckPlan(state, settings);
    ray::CheckState(state, film, settings);
  } catch (const ray::CheckpointError&) {
  }
  return 0;
}
