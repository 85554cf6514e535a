#include <cstdint>
#include <cstdio>
// After cstdio, whose FILE it takes for granted.
#include <jerror.h>
#include <jpeglib.h>

#include <algorithm>
#include <string_view>

#include "R2/image_files/Jump.h"
#include "R2/image_files/formats.h"

// JPEG through libjpeg. Settings live in the comment marker, a line of "key: value" each.
// source: ITU-T T.81 (1992); libjpeg.txt of the library
namespace R2 {

namespace jpeg {
namespace {

constexpr std::size_t marker_capacity = 65533;  // a marker's length has 16 bits and counts itself
// Up to this many pixels, Huffman tables are optimized for the image: the same pixels in 3 to 10 % fewer bytes (the
// pictures of art/ at quality 88), or a quarter fewer where most is even. For that libjpeg keeps all coefficients, 6
// bytes per pixel, here 384 MiB.
constexpr std::int64_t most_to_optimize = std::int64_t{1} << 26;

struct ErrorManager {
  jpeg_error_mgr base;  // first, so that the library's pointer to it is also a pointer to this
  Jump jump;
};

Jump& JumpOf(j_common_ptr codec) { return reinterpret_cast<ErrorManager*>(codec->err)->jump; }

[[noreturn]] void OnError(j_common_ptr codec) {
  char message[JMSG_LENGTH_MAX];
  codec->err->format_message(codec, message);
  JumpOf(codec).Leave(message);
}

/// Level -1 is a warning: data is missing or corrupt and the library would go on with gray. Others are chatter.
void OnMessage(j_common_ptr codec, int level) {
  if (level < 0) OnError(codec);
}

jpeg_error_mgr* Prepare(ErrorManager& errors) {
  jpeg_std_error(&errors.base);
  errors.base.error_exit = OnError;
  errors.base.emit_message = OnMessage;
  return &errors.base;
}

// --- settings ---

/// One line without line breaks; a colon is escaped in keys only, so that the first bare one ends the key.
std::string Escaped(const std::string& text, bool is_key) {
  std::string escaped;
  for (char c : text) {
    if (c == '\n') {
      escaped += "\\n";
    } else if (c == '\r') {
      escaped += "\\r";
    } else if (c == '\\' || (is_key && c == ':')) {
      escaped += {'\\', c};
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string Unescaped(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_escape = text[i] == '\\' && i + 1 < text.size();
    const char next = is_escape ? text[i + 1] : '\0';
    if (next == 'n' || next == 'r') {
      plain += next == 'n' ? '\n' : '\r';
      ++i;
    } else if (next == '\\' || next == ':') {
      plain += next;
      ++i;
    } else {
      plain += text[i];
    }
  }
  return plain;
}

std::string CommentText(const ImageSettings& settings) {
  std::string text;
  for (const auto& [key, value] : settings) text += Escaped(key, true) + ": " + Escaped(value, false) + "\n";
  return text;
}

/// A line of another program's without a key is kept under "comment".
void AddLine(ImageSettings& settings, std::string_view line) {
  std::size_t colon = 0;
  while (colon < line.size() && line[colon] != ':') colon += line[colon] == '\\' ? 2 : 1;
  if (colon + 1 < line.size() && line[colon + 1] == ' ') {
    settings.insert_or_assign(Unescaped(line.substr(0, colon)), Unescaped(line.substr(colon + 2)));
    return;
  }
  std::string& comment = settings["comment"];
  comment += (comment.empty() ? "" : "\n") + std::string(line);
}

/// A full comment marker goes on in the next one; any other ends with a line.
ImageSettings SettingsOf(const jpeg_decompress_struct& codec) {
  std::string text;
  for (const jpeg_marker_struct* marker = codec.marker_list; marker; marker = marker->next) {
    text.append(reinterpret_cast<const char*>(marker->data), marker->data_length);
    if (marker->data_length < marker_capacity) text += '\n';
  }
  ImageSettings settings;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    if (!line.empty()) AddLine(settings, line);
  }
  return settings;
}

// --- reading ---

/// A progressive file may describe the picture in ever new scans; a small file with thousands of them over a large
/// picture would take hours. Ten are usual.
void StopAtManyScans(j_common_ptr codec) {
  constexpr int most_scans = 200;
  const auto* decoder = reinterpret_cast<j_decompress_ptr>(codec);
  if (decoder->input_scan_number > most_scans) JumpOf(codec).Leave("there are more than 200 scans");
}

/// Owns the library's decoder of one picture.
class Decoder {
 public:
  Decoder() { codec_.err = Prepare(errors_); }
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
      jpeg_read_header(&codec_, TRUE);
    });
    if (codec_.num_components != 1 && codec_.num_components != 3) {
      throw ImageError("JPEG has " + std::to_string(codec_.num_components) +
                       " components (CMYK?); only 1 (gray) and 3 (color) are supported");
    }
    return CheckedSize("JPEG", codec_.image_width, codec_.image_height);
  }

  void Start() {
    codec_.out_color_space = JCS_RGB;
    Do([&] { jpeg_start_decompress(&codec_); });
  }

  void ReadRow(std::span<unsigned char> row) {
    JSAMPROW rows[1] = {row.data()};
    // Without a warning, which is an error here, the library always delivers the row.
    Do([&] { jpeg_read_scanlines(&codec_, rows, 1); });
  }

  /// Of the comments before the last row; to be asked for before Finish, which drops them.
  ImageSettings Settings() const { return SettingsOf(codec_); }

  /// Reads up to the end marker, so that a missing end is noticed.
  void Finish() {
    Do([&] { jpeg_finish_decompress(&codec_); });
  }

 private:
  template <typename Call>
  void Do(const Call& call) {
    if (Completes(errors_.jump, call)) return;
    const std::string rows = std::to_string(codec_.output_scanline) + " of " + std::to_string(codec_.image_height);
    if (errors_.base.msg_code == JWRN_JPEG_EOF || errors_.base.msg_code == JERR_INPUT_EMPTY) {
      throw ImageError("JPEG is truncated: " + rows + " rows are there");
    }
    throw ImageError("JPEG is damaged or of an unknown kind, after " + rows + " rows: " + errors_.jump.message);
  }

  ErrorManager errors_{};
  jpeg_progress_mgr progress_{};
  jpeg_decompress_struct codec_{};
};

bool Recognizes(std::span<const unsigned char> bytes) {
  return bytes.size() >= 3 && bytes[0] == 0xff && bytes[1] == 0xd8 && bytes[2] == 0xff;
}

ImageSize ReadSize(std::span<const unsigned char> bytes) { return Decoder().ReadHeader(bytes); }

DecodedImage Decode(std::span<const unsigned char> bytes) {
  Decoder decoder;
  const ImageSize size = decoder.ReadHeader(bytes);
  decoder.Start();
  // The picture is asked for only once its first row is there: the header alone may promise anything.
  DecodedImage decoded;
  Image& image = decoded.image;
  std::vector<unsigned char> row(3 * static_cast<std::size_t>(size.width));
  for (int y = size.height - 1; y >= 0; --y) {
    decoder.ReadRow(row);
    if (image.Width() == 0) image = Image(size.width, size.height);
    SetByteRow(image, y, row);
  }
  decoded.settings = decoder.Settings();
  decoder.Finish();
  return decoded;
}

/// Comments between the scans of a progressive file are not met.
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

/// The library wants the whole block written, whatever free_in_buffer says.
boolean OnBlockFull(j_compress_ptr codec) {
  Flush(codec, sizeof(Destination::block));
  return TRUE;
}

void OnWriteEnd(j_compress_ptr codec) { Flush(codec, sizeof(Destination::block) - codec->dest->free_in_buffer); }

/// Owns the library's encoder of one picture.
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
      // The default halves the resolution of color, which rendered edges show.
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

const ImageFormat jpeg_format{
    "jpeg",  {"jpg", "jpeg", "jpe"}, jpeg::Recognizes, jpeg::ReadSize, jpeg::Decode, jpeg::Encode, false,
    nullptr, jpeg::ReadSettings};

}  // namespace R2
