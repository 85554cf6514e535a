#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include "rayimg/Commands.h"
#include "rayimg/Images.h"
#include "source/app/Status.h"
#include "source/app/report/Info.h"
#include "source/app/report/Messages.h"
#include "source/text/LowerCase.h"
#include "source/text/Quoting.h"

// AVI is RIFF: chunks of four letters, a size and as many bytes; a LIST's first four letters state its content.
//   RIFF 'AVI '
//     LIST 'hdrl'       avih: the movie; LIST 'strl' { strh: its one stream; strf: its images }
//     LIST 'movi'       00dc: a frame, the bytes of a JPEG; and so on
//     idx1              where each frame is, so that players can jump
// source: Microsoft, AVI RIFF File Reference (AVIMAINHEADER, AVISTREAMHEADER, AVIOLDINDEX, BITMAPINFOHEADER)
namespace ray::rayimg {
namespace {

using Bytes = std::vector<unsigned char>;

// Sizes have 32 bits, but some readers treat them as signed.
constexpr std::uint64_t most_bytes = (std::uint64_t{1} << 31) - 1;
constexpr std::uint32_t scale = 1000;       // frames per second are counted in thousandths
constexpr const char* frame_name = "00dc";  // of stream 0, compressed

struct Frames {
  R2::ImageSize size;
  std::vector<Bytes> jpegs;  // one per frame
};

void Append(Bytes& bytes, std::string_view letters) { bytes.insert(bytes.end(), letters.begin(), letters.end()); }

/// Appends a number with the lowest byte first, as everywhere in RIFF.
void Append(Bytes& bytes, std::uint64_t number, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<unsigned char>(number >> (8 * i)));
}
void Append16(Bytes& bytes, std::uint64_t number) { Append(bytes, number, 2); }
void Append32(Bytes& bytes, std::uint64_t number) { Append(bytes, number, 4); }

/// Appends a chunk. One of odd size is followed by a zero that its size does not count.
void AppendChunk(Bytes& bytes, std::string_view name, const Bytes& content) {
  Append(bytes, name);
  Append32(bytes, content.size());
  bytes.insert(bytes.end(), content.begin(), content.end());
  if (content.size() % 2) bytes.push_back(0);
}

Bytes List(std::string_view kind, std::initializer_list<std::pair<std::string_view, Bytes>> chunks) {
  Bytes list;
  Append(list, kind);
  for (const auto& [name, content] : chunks) AppendChunk(list, name, content);
  return list;
}

std::size_t LargestFrame(const Frames& frames) { return std::ranges::max(frames.jpegs, {}, &Bytes::size).size(); }

Bytes MovieHeader(const Frames& frames, double fps) {
  constexpr std::uint32_t has_index = 0x10;
  const auto bytes_a_second = static_cast<double>(LargestFrame(frames)) * fps;
  Bytes header;
  Append32(header, static_cast<std::uint64_t>(std::llround(1e6 / fps)));  // microseconds per frame
  Append32(header, static_cast<std::uint64_t>(std::min(bytes_a_second, double{most_bytes})));
  Append32(header, 0);  // no padding beyond that of RIFF
  Append32(header, has_index);
  Append32(header, frames.jpegs.size());
  Append32(header, 0);  // frames before the first
  Append32(header, 1);  // streams
  Append32(header, LargestFrame(frames));
  Append32(header, static_cast<std::uint64_t>(frames.size.width));
  Append32(header, static_cast<std::uint64_t>(frames.size.height));
  for (int i = 0; i < 4; ++i) Append32(header, 0);  // reserved
  return header;
}

Bytes StreamHeader(const Frames& frames, double fps) {
  constexpr std::uint32_t unknown_quality = 0xffffffff;
  Bytes header;
  Append(header, "vids");
  Append(header, "MJPG");
  Append32(header, 0);  // flags
  Append32(header, 0);  // priority and language, 16 bits each
  Append32(header, 0);  // frames before the first
  Append32(header, scale);
  Append32(header, static_cast<std::uint64_t>(std::llround(fps * scale)));
  Append32(header, 0);  // start
  Append32(header, frames.jpegs.size());
  Append32(header, LargestFrame(frames));
  Append32(header, unknown_quality);
  Append32(header, 0);  // samples vary in size
  Append16(header, 0);  // left, top, right, bottom
  Append16(header, 0);
  Append16(header, static_cast<std::uint64_t>(frames.size.width));
  Append16(header, static_cast<std::uint64_t>(frames.size.height));
  return header;
}

Bytes StreamFormat(const R2::ImageSize& size) {
  const auto width = static_cast<std::uint64_t>(size.width), height = static_cast<std::uint64_t>(size.height);
  constexpr std::uint32_t own_size = 40;
  Bytes format;
  Append32(format, own_size);
  Append32(format, width);
  Append32(format, height);
  Append16(format, 1);   // planes
  Append16(format, 24);  // bits per pixel
  Append(format, "MJPG");
  Append32(format, std::min(3 * width * height, most_bytes));  // bytes of an image; a hint for players
  for (int i = 0; i < 4; ++i) Append32(format, 0);             // pixels per meter, twice; colors of a palette, twice
  return format;
}

/// Returns the index. Positions count from the letters 'movi'.
Bytes Index(const std::vector<Bytes>& jpegs) {
  constexpr std::uint32_t key_frame = 0x10;  // independent of other frames
  Bytes index;
  std::uint64_t at = 4;
  for (const Bytes& jpeg : jpegs) {
    Append(index, frame_name);
    Append32(index, key_frame);
    Append32(index, at);
    Append32(index, jpeg.size());
    at += 8 + jpeg.size() + jpeg.size() % 2;
  }
  return index;
}

Bytes Avi(const Frames& frames, double fps) {
  Bytes movie;
  Append(movie, "movi");
  for (const Bytes& jpeg : frames.jpegs) AppendChunk(movie, frame_name, jpeg);
  const Bytes stream = List("strl", {{"strh", StreamHeader(frames, fps)}, {"strf", StreamFormat(frames.size)}});
  Bytes avi;
  AppendChunk(avi, "RIFF",
              List("AVI ", {{"LIST", List("hdrl", {{"avih", MovieHeader(frames, fps)}, {"LIST", stream}})},
                            {"LIST", movie},
                            {"idx1", Index(frames.jpegs)}}));
  return avi;
}

/// Reads and decodes every frame, since a player would stop at a damaged one.
Frames ReadFrames(const std::vector<std::string>& names) {
  Frames frames;
  R2::Image first;
  std::uint64_t bytes = 1024;  // more than all headers
  for (const std::string& name : names) {
    Bytes jpeg = ReadBytes(name);
    const R2::DecodedImage decoded = DecodeImageFile(name, jpeg);
    PrintWarnings(name, decoded.warnings);
    if (std::string_view(decoded.format->name) != "jpeg")
      throw UsageError(Quoted(name) + " is a " + decoded.format->name + "; the frames of a movie are jpeg");
    if (decoded.is_turned)
      throw UsageError(Quoted(name) + " has an orientation, which movie players ignore; rayimg convert applies it");
    if (frames.jpegs.empty()) first = decoded.image;
    RefuseOtherSize(names[0], first, name, decoded.image);
    bytes += jpeg.size() + 8 + 16 + 1;  // its chunk header, its index entry, and its padding
    if (bytes > most_bytes) throw UsageError("the movie would be larger than 2 GiB, at " + Quoted(name));
    frames.jpegs.push_back(std::move(jpeg));
  }
  frames.size = {first.Width(), first.Height()};
  return frames;
}

OutputFile CheckMovie(const std::string& name, const std::vector<std::string>& inputs) {
  if (!LowerCase(name).ends_with(".avi")) throw UsageError("a movie's name ends in .avi, not " + Quoted(name));
  return CheckOutput(name, inputs);
}

}  // namespace

int Movie(const ImageOptions& options, const std::string&) {
  const std::vector<std::string> names(options.names.begin() + 1, options.names.end());
  const OutputFile output = CheckMovie(options.names[0], names);
  const Frames frames = ReadFrames(names);
  if (output.is_link)
    PrintError("rayimg: " + Quoted(output.name) + " is a link; the movie goes to " + Quoted(output.target.string()));
  WriteWhole(output, Avi(frames, options.fps));
  return status::done;
}

}  // namespace ray::rayimg
