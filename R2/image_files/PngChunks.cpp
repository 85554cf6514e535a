#include "R2/image_files/PngChunks.h"

#include <zlib.h>

#include <algorithm>

#include "R2/image_files/ByteReader.h"

namespace R2 {
namespace {

constexpr std::size_t signature_size = 8, name_end = 8;  // a length, then a name
constexpr std::uint64_t bytes_around_data = 12;          // and a checksum behind them

}  // namespace

PngChunks::PngChunks(std::span<const unsigned char> file)
    : rest_(file.subspan(std::min(signature_size, file.size()))) {}

bool PngChunks::Next() {
  if (rest_.empty() || (!chunk_.empty() && IsEnd())) return false;
  const bool has_length = rest_.size() >= name_end;
  const std::uint64_t length =
      has_length ? ByteReader("PNG", rest_).Big32("a chunk") + bytes_around_data : bytes_around_data;
  is_cut_ = length > rest_.size();
  chunk_ = rest_.first(static_cast<std::size_t>(std::min<std::uint64_t>(length, rest_.size())));
  rest_ = rest_.subspan(chunk_.size());
  return true;
}

std::string_view PngChunks::Name() const {
  if (chunk_.size() < name_end) return {};
  return {reinterpret_cast<const char*>(chunk_.data()) + 4, 4};
}

bool PngChunks::HasRightChecksum() const {
  const auto named = chunk_.subspan(4, chunk_.size() - 8);
  const auto computed = crc32_z(crc32_z(0, nullptr, 0), named.data(), named.size());
  return computed == ByteReader("PNG", chunk_.last(4)).Big32("a checksum");
}

void CheckPngChunks(std::span<const unsigned char> file) {
  for (PngChunks chunks(file); chunks.Next();) {
    if (!chunks.IsCut() || chunks.Name() == "IDAT") continue;
    ByteReader reader("PNG", chunks.All());
    const std::uint64_t length = chunks.All().size() < name_end ? 0 : reader.Big32("a chunk");
    ByteReader("PNG", chunks.All()).Need(length + bytes_around_data, "a chunk");
  }
}

Orientation PngOrientation(std::span<const unsigned char> file) {
  for (PngChunks chunks(file); chunks.Next();)
    if (chunks.Name() == "eXIf" && !chunks.IsCut() && chunks.HasRightChecksum()) return ExifOrientation(chunks.Data());
  return {};
}

PngEnd FindPngEnd(std::span<const unsigned char> file) {
  PngEnd end;
  for (PngChunks chunks(file); chunks.Next();)
    end = {chunks.IsEnd() && !chunks.IsCut(), chunks.BytesBehind()};
  return end;
}

std::vector<unsigned char> PngWithoutPixels(std::span<const unsigned char> file) {
  std::vector<unsigned char> rest(file.begin(), file.begin() + signature_size);
  for (PngChunks chunks(file); chunks.Next() && !chunks.IsEnd();)
    if (chunks.Name() != "IDAT" && chunks.All().size() >= name_end)
      rest.insert(rest.end(), chunks.All().begin(), chunks.All().end());
  rest.insert(rest.end(), {0, 0, 0, 0, 'I', 'D', 'A', 'T'});
  return rest;
}

}  // namespace R2
