#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "R2/image_files/Orientation.h"

/// The chunks of a PNG file, stepped over without its library.
/// source: W3C, Portable Network Graphics (PNG) Specification, 2nd ed. (2003), section 5; 3rd ed. (2025), 11.3.4.5,
/// eXIf
namespace R2 {

class PngChunks {
 public:
  explicit PngChunks(std::span<const unsigned char> file);

  /// Steps to the first chunk, or to the next. Returns false behind the end chunk and where the file ends.
  bool Next();

  std::string_view Name() const;
  bool IsCut() const { return is_cut_; }  // the file ends before the chunk does
  bool IsEnd() const { return Name() == "IEND"; }
  /// What is there of the chunk: length, name, data and checksum.
  std::span<const unsigned char> All() const { return chunk_; }
  /// The data of a chunk that is not cut.
  std::span<const unsigned char> Data() const { return chunk_.subspan(8, chunk_.size() - 12); }
  /// Whether the checksum is right; only for a chunk that is not cut.
  bool HasRightChecksum() const;
  std::uint64_t BytesBehind() const { return rest_.size(); }

 private:
  std::span<const unsigned char> chunk_, rest_;
  bool is_cut_ = false;
};

/// Throws ImageError when a chunk is cut. The library makes room for a whole chunk before it reads any of it, so a
/// length has to be within the file. Pixels are read piece by piece, and a file cut among them is better told by its
/// rows.
void CheckPngChunks(std::span<const unsigned char> file);

/// The orientation that a chunk of EXIF asks for.
Orientation PngOrientation(std::span<const unsigned char> file);

/// How a PNG file ends.
struct PngEnd {
  bool has_end_chunk = false;
  std::uint64_t bytes_behind = 0;
};
PngEnd FindPngEnd(std::span<const unsigned char> file);

/// The file with its pixels at the end, and only begun: there the library stops. So text behind them counts, and none
/// is unpacked. A file cut short among its pixels has no more than stands before them.
std::vector<unsigned char> PngWithoutPixels(std::span<const unsigned char> file);

}  // namespace R2
