#include <cstdint>
#include <cstdio>
// After cstdio, because jerror.h needs FILE.
#include <jerror.h>
#include <jpeglib.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "R2/image_files/ColorProfile.h"
#include "R2/image_files/Jump.h"
#include "R2/image_files/Orientation.h"
#include "R2/image_files/TextSettings.h"
#include "R2/image_files/formats.h"

// JPEG through libjpeg. Settings are stored in the comment marker, one line of "key: value" each.
// source: ITU-T T.81 (1992); libjpeg.txt of the library
namespace R2 {

namespace jpeg {
namespace {

constexpr std::size_t marker_capacity = 65533;  // a marker's length has 16 bits and includes itself
// Up to this many pixels, Huffman tables are optimized for the image: the same pixels in 3 to 10 % fewer bytes (the
// images of art/ at quality 88), or a quarter fewer for mostly uniform images. For that, libjpeg keeps all
// coefficients, 6 bytes per pixel, here 384 MiB.
constexpr std::int64_t most_to_optimize = std::int64_t{1} << 26;
// Every block of 8 by 8 pixels takes at least one bit.
constexpr std::uint64_t most_pixels_per_byte = 8 * 64;

/// The library's warnings about an image that can still be read. Nothing here allocates, since the library calls it.
struct Warnings {
  bool are_errors = false;               // warnings are errors
  bool is_damaged = false;               // pixels may be wrong; otherwise the file is merely unusual
  int count = 0;                         // of all warnings
  char first[JMSG_LENGTH_MAX + 1] = "";  // the first one, or the first about damage
};

struct ErrorManager {
  jpeg_error_mgr base;  // first, so that the library's pointer to it is also a pointer to this
  Jump jump;
  Warnings* warnings = nullptr;  // the warnings that a reader ignores; null for writers, which treat each as an error
};

ErrorManager& ErrorsOf(j_common_ptr codec) { return *reinterpret_cast<ErrorManager*>(codec->err); }
Jump& JumpOf(j_common_ptr codec) { return ErrorsOf(codec).jump; }

[[noreturn]] void OnError(j_common_ptr codec) {
  char message[JMSG_LENGTH_MAX];
  codec->err->format_message(codec, message);
  JumpOf(codec).Leave(message);
}

/// Returns true if the warning affects no pixel.
bool IsHarmless(int code) {
  constexpr std::array harmless{JWRN_ADOBE_XFORM, JWRN_EXTRANEOUS_DATA, JWRN_JFIF_MAJOR, JWRN_NOT_SEQUENTIAL,
                                JWRN_TOO_MUCH_DATA};
  return std::ranges::find(harmless, code) != harmless.end();
}

/// Returns true if the data end before the image does, in which case the library would fill the rest with gray. In a
/// file with restart markers, such a marker ends only a section of the image.
bool EndsTooSoon(j_decompress_ptr codec) {
  const int code = codec->err->msg_code;
  const bool is_at_restart =
      codec->restart_interval > 0 && codec->unread_marker >= JPEG_RST0 && codec->unread_marker <= JPEG_RST0 + 7;
  return code == JWRN_JPEG_EOF || ((code == JWRN_HIT_MARKER || code == JWRN_MUST_RESYNC) && !is_at_restart);
}

/// Handles a message: level -1 is a warning, all others are informational.
void OnMessage(j_common_ptr codec, int level) {
  if (level >= 0) return;
  Warnings* const warnings = ErrorsOf(codec).warnings;
  if (!warnings || warnings->are_errors || EndsTooSoon(reinterpret_cast<j_decompress_ptr>(codec))) OnError(codec);
  const bool is_damage = !IsHarmless(codec->err->msg_code);
  if (warnings->count == 0 || (is_damage && !warnings->is_damaged)) codec->err->format_message(codec, warnings->first);
  warnings->is_damaged = warnings->is_damaged || is_damage;
  ++warnings->count;
}

jpeg_error_mgr* Prepare(ErrorManager& errors) {
  jpeg_std_error(&errors.base);
  errors.base.error_exit = OnError;
  errors.base.emit_message = OnMessage;
  return &errors.base;
}

// --- reading ---

/// Returns the settings. A full comment marker continues in the next one; any other ends with a line.
ImageSettings SettingsOf(const jpeg_decompress_struct& codec) {
  std::string text;
  for (const jpeg_marker_struct* marker = codec.marker_list; marker; marker = marker->next) {
    if (marker->marker != JPEG_COM) continue;
    text.append(reinterpret_cast<const char*>(marker->data), marker->data_length);
    if (marker->data_length < marker_capacity) text += '\n';
  }
  return SettingsOfComment(text);
}

constexpr int exif_marker = JPEG_APP0 + 1, profile_marker = JPEG_APP0 + 2;

/// Returns the contents of the markers with the given number that begin with `start`, without it.
std::vector<std::span<const unsigned char>> MarkersOf(const jpeg_decompress_struct& codec, int number,
                                                      std::string_view start) {
  std::vector<std::span<const unsigned char>> found;
  for (const jpeg_marker_struct* marker = codec.marker_list; marker; marker = marker->next) {
    const std::span<const unsigned char> data(marker->data, marker->data_length);
    if (marker->marker == number && data.size() >= start.size() && std::equal(start.begin(), start.end(), data.begin()))
      found.push_back(data.subspan(start.size()));
  }
  return found;
}

/// Returns the orientation that cameras store in an EXIF block, of which the first counts.
Orientation OrientationOf(const jpeg_decompress_struct& codec) {
  const auto blocks = MarkersOf(codec, exif_marker, std::string_view("Exif\0\0", 6));
  return blocks.empty() ? Orientation{} : ExifOrientation(blocks[0]);
}

/// Returns true if the file has a profile other than sRGB. A profile may be split into pieces; its name is in the
/// first.
bool HasOtherProfile(const jpeg_decompress_struct& codec) {
  const auto pieces = MarkersOf(codec, profile_marker, std::string_view("ICC_PROFILE\0", 12));
  return !pieces.empty() && std::ranges::none_of(pieces, IsNamedSrgb);
}

/// Stops at too many scans. A progressive file may refine the image in any number of scans; a small file with thousands
/// of them for a large image would take hours. Ten are usual.
void StopAtManyScans(j_common_ptr codec) {
  constexpr int most_scans = 200;
  const auto* decoder = reinterpret_cast<j_decompress_ptr>(codec);
  if (decoder->input_scan_number > most_scans) JumpOf(codec).Leave("there are more than 200 scans");
}

/// Owns the library's decoder of one image.
class Decoder {
 public:
  Decoder() {
    codec_.err = Prepare(errors_);
    errors_.warnings = &warnings_;
  }
  // Does nothing to a codec that was never created: its memory manager is null.
  ~Decoder() { jpeg_destroy_decompress(&codec_); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  ImageSize ReadHeader(std::span<const unsigned char> bytes) {
    progress_.progress_monitor = StopAtManyScans;
    Do([&] {
      jpeg_create_decompress(&codec_);
      codec_.progress = &progress_;
      jpeg_mem_src(&codec_, bytes.data(), static_cast<unsigned long>(bytes.size()));
      jpeg_save_markers(&codec_, JPEG_COM, 0xffff);
      jpeg_save_markers(&codec_, exif_marker, 0xffff);
      jpeg_save_markers(&codec_, profile_marker, 0xffff);
      jpeg_read_header(&codec_, TRUE);
    });
    if (codec_.num_components != 1 && codec_.num_components != 3 && !HasInks()) {
      throw ImageError("JPEG has " + std::to_string(codec_.num_components) +
                       " components; 1 (gray), 3 (color) and 4 (CMYK) are supported");
    }
    // Missing data cost the file's author nothing, so a file that is too small for its pixels is rejected.
    const std::uint64_t pixels = std::uint64_t{codec_.image_width} * codec_.image_height;
    warnings_.are_errors = pixels > most_pixels_per_byte * bytes.size();
    return CheckedSize("JPEG", codec_.image_width, codec_.image_height);
  }

  /// Returns true if pixels are cyan, magenta, yellow and black.
  bool HasInks() const { return codec_.num_components == 4; }

  /// Returns true if the header has a color profile other than sRGB. Must be called before Finish.
  bool HasOtherColors() const { return HasOtherProfile(codec_); }

  /// Returns the orientation stored in the header.
  Orientation StatedOrientation() const { return OrientationOf(codec_); }

  void Start() {
    codec_.out_color_space = HasInks() ? JCS_CMYK : JCS_RGB;
    Do([&] { jpeg_start_decompress(&codec_); });
  }

  void ReadRow(std::span<unsigned char> row) {
    JSAMPROW rows[1] = {row.data()};
    // Without an error the library always delivers the row.
    Do([&] { jpeg_read_scanlines(&codec_, rows, 1); });
  }

  /// Returns the settings from the comments read so far. Must be called before Finish, which drops them.
  ImageSettings Settings() const { return SettingsOf(codec_); }

  /// Reads up to the end marker, so that a missing end is noticed.
  void Finish() {
    Do([&] { jpeg_finish_decompress(&codec_); });
  }

  /// Returns the number of bytes after the end marker, once that was read.
  std::size_t BytesBehind() const { return codec_.src->bytes_in_buffer; }

  /// Returns sentences about all oddities so far.
  std::vector<std::string> WarningTexts() const {
    if (warnings_.count == 0) return {};
    const std::string more = warnings_.count > 1 ? " (and " + std::to_string(warnings_.count - 1) + " more)" : "";
    return {(warnings_.is_damaged ? "JPEG is damaged, and parts of the image may be wrong: "
                                  : "JPEG is unusual, yet the whole image was read: ") +
            std::string(warnings_.first) + more};
  }

 private:
  template <typename Call>
  void Do(const Call& call) {
    if (Completes(errors_.jump, call)) return;
    const std::string rows = std::to_string(codec_.output_scanline) + " of " + std::to_string(codec_.image_height);
    if (errors_.base.msg_code == JWRN_JPEG_EOF || errors_.base.msg_code == JERR_INPUT_EMPTY) {
      throw ImageError("JPEG is truncated: " + rows + " rows are present");
    }
    throw ImageError("JPEG is damaged or of an unknown kind, after " + rows + " rows: " + errors_.jump.message);
  }

  Warnings warnings_{};
  ErrorManager errors_{};
  jpeg_progress_mgr progress_{};
  jpeg_decompress_struct codec_{};
};

bool Recognizes(std::span<const unsigned char> bytes) {
  return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

ImageSize ReadSize(std::span<const unsigned char> bytes) {
  Decoder decoder;
  const ImageSize stored = decoder.ReadHeader(bytes);
  return Turned(stored, decoder.StatedOrientation());
}

/// Sets one row of CMYK inks without a color profile. 255 means no ink, a convention that all programs adopted from
/// Adobe's.
void SetInkRow(Image& image, int y, std::span<const unsigned char> row) {
  for (int x = 0; x < image.Width(); ++x) {
    const auto ink = row.subspan(4 * static_cast<std::size_t>(x), 4);
    const double unprinted = ink[3] / 255.0;
    image.Set(x, y, {ink[0] / 255.0 * unprinted, ink[1] / 255.0 * unprinted, ink[2] / 255.0 * unprinted});
  }
}

DecodedImage Decode(std::span<const unsigned char> bytes) {
  Decoder decoder;
  const ImageSize size = decoder.ReadHeader(bytes);
  decoder.Start();
  // The image is allocated only after its first row was read, since the header alone may claim any size.
  DecodedImage decoded;
  Image& image = decoded.image;
  std::vector<unsigned char> row((decoder.HasInks() ? 4 : 3) * static_cast<std::size_t>(size.width));
  for (int y = size.height - 1; y >= 0; --y) {
    decoder.ReadRow(row);
    if (image.Width() == 0) image = Image(size.width, size.height);
    decoder.HasInks() ? SetInkRow(image, y, row) : SetByteRow(image, y, row);
  }
  Turn(decoded, decoder.StatedOrientation());
  decoded.settings = decoder.Settings();
  const bool has_other_colors = decoder.HasOtherColors();
  decoder.Finish();
  decoded.warnings = decoder.WarningTexts();
  if (has_other_colors) decoded.warnings.push_back(std::string("JPEG") + other_profile);
  WarnOfBytesBehind(decoded, "JPEG", decoder.BytesBehind());
  return decoded;
}

/// Reads the settings from the header. Comments between the scans of a progressive file are missed.
ImageSettings ReadSettings(std::span<const unsigned char> bytes) {
  Decoder decoder;
  decoder.ReadHeader(bytes);
  return decoder.Settings();
}

// --- writing ---

/// Collects what the encoder writes.
struct Destination {
  jpeg_destination_mgr base;  // first, like the error manager's
  std::vector<unsigned char>* bytes;
  unsigned char block[16384];

  void Restart() {
    base.next_output_byte = block;
    base.free_in_buffer = sizeof(block);
  }
};

Destination& DestinationOf(j_compress_ptr codec) { return *reinterpret_cast<Destination*>(codec->dest); }

void Flush(j_compress_ptr codec, std::size_t count) {
  Destination& destination = DestinationOf(codec);
  if (!Append(*destination.bytes, destination.block, count)) {
    JumpOf(reinterpret_cast<j_common_ptr>(codec)).Leave("not enough memory");
  }
  destination.Restart();
}

void OnWriteStart(j_compress_ptr codec) { DestinationOf(codec).Restart(); }

/// Called when the block is full. The library wants the whole block written, whatever free_in_buffer says.
boolean OnBlockFull(j_compress_ptr codec) {
  Flush(codec, sizeof(Destination::block));
  return TRUE;
}

void OnWriteEnd(j_compress_ptr codec) { Flush(codec, sizeof(Destination::block) - codec->dest->free_in_buffer); }

/// Owns the library's encoder of one image.
class Encoder {
 public:
  Encoder() {
    codec_.err = Prepare(errors_);
    destination_.base.init_destination = OnWriteStart;
    destination_.base.empty_output_buffer = OnBlockFull;
    destination_.base.term_destination = OnWriteEnd;
    destination_.bytes = &bytes_;
  }
  ~Encoder() { jpeg_destroy_compress(&codec_); }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  void Start(ImageSize size, int quality, const std::string& comment) {
    Do([&] {
      jpeg_create_compress(&codec_);
      codec_.dest = &destination_.base;
      codec_.image_width = static_cast<JDIMENSION>(size.width);
      codec_.image_height = static_cast<JDIMENSION>(size.height);
      codec_.input_components = 3;
      codec_.in_color_space = JCS_RGB;
      jpeg_set_defaults(&codec_);
      jpeg_set_quality(&codec_, quality, TRUE);
      // The default halves the resolution of color, which is visible at rendered edges.
      codec_.comp_info[0].h_samp_factor = codec_.comp_info[0].v_samp_factor = 1;
      codec_.optimize_coding = std::int64_t{size.width} * size.height <= most_to_optimize;
      jpeg_start_compress(&codec_, TRUE);
      const auto* text = reinterpret_cast<const JOCTET*>(comment.data());
      for (std::size_t start = 0; start < comment.size(); start += marker_capacity) {
        const std::size_t length = std::min(marker_capacity, comment.size() - start);
        jpeg_write_marker(&codec_, JPEG_COM, text + start, static_cast<unsigned>(length));
      }
    });
  }

  void WriteRow(std::span<unsigned char> row) {
    JSAMPROW rows[1] = {row.data()};
    Do([&] { jpeg_write_scanlines(&codec_, rows, 1); });
  }

  std::vector<unsigned char> Finish() {
    Do([&] { jpeg_finish_compress(&codec_); });
    return std::move(bytes_);
  }

 private:
  template <typename Call>
  void Do(const Call& call) {
    if (!Completes(errors_.jump, call))
      throw ImageError(std::string("JPEG cannot be written: ") + errors_.jump.message);
  }

  ErrorManager errors_{};
  Destination destination_{};
  std::vector<unsigned char> bytes_;
  jpeg_compress_struct codec_{};
};

std::vector<unsigned char> Encode(const Image& image, const ImageEncoding& encoding, const ImageSettings& settings) {
  Encoder encoder;
  encoder.Start({image.Width(), image.Height()}, encoding.jpeg_quality, CommentText(settings));
  for (int y = image.Height() - 1; y >= 0; --y) {
    auto row = ByteRow(image, y, encoding);
    encoder.WriteRow(row);
  }
  return encoder.Finish();
}

}  // namespace
}  // namespace jpeg

extern const ImageFormat jpeg_format{
    "jpeg",  {"jpg", "jpeg", "jpe"}, jpeg::Recognizes, jpeg::ReadSize, jpeg::Decode, jpeg::Encode, false,
    nullptr, jpeg::ReadSettings};

}  // namespace R2
