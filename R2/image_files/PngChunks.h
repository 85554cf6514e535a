#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "R2/image_files/Orientation.h"

/// A reader of the chunks of a PNG file that does not use its library.
/// source: W3C, Portable Network Graphics (PNG) Specification, 2nd ed. (2003), section 5; 3rd ed. (2025), 11.3.4.5,
/// eXIf
namespace R2 {

class PngChunks {
 public:
  explicit PngChunks(std::span<const unsigned char> file);

  /// Advances to the first or next chunk. Returns false after the end chunk or at the end of the file.
  bool Next();

  std::string_view Name() const;
  bool IsCut() const { return is_cut_; }  // the file ends inside the chunk
  bool IsEnd() const { return Name() == "IEND"; }
  /// Returns the available bytes of the chunk: length, name, data and checksum.
  std::span<const unsigned char> All() const { return chunk_; }
  /// Returns the data of a complete chunk.
  std::span<const unsigned char> Data() const { return chunk_.subspan(8, chunk_.size() - 12); }
  /// Returns true if the checksum of a complete chunk is correct.
  bool HasRightChecksum() const;
  std::uint64_t BytesBehind() const { return rest_.size(); }

 private:
  std::span<const unsigned char> chunk_, rest_;
  bool is_cut_ = false;
};

/// Throws ImageError if a chunk is truncated. The library allocates a whole chunk before it reads it, so a length must
/// be inside the file. Pixels are read incrementally; a file truncated among them is reported by its rows instead.
void CheckPngChunks(std::span<const unsigned char> file);

/// Returns the orientation stored in the file's EXIF chunk.
Orientation PngOrientation(std::span<const unsigned char> file);

/// The end of a PNG file.
struct PngEnd {
  bool has_end_chunk = false;
  std::uint64_t bytes_behind = 0;
};
PngEnd FindPngEnd(std::span<const unsigned char> file);

/// Returns the file with its pixels moved to the end and truncated, where the library stops. This way the library reads
/// the text after the pixels but decompresses none of them. A file truncated among its pixels keeps only what precedes
/// them.
std::vector<unsigned char> PngWithoutPixels(std::span<const unsigned char> file);

}  // namespace R2
