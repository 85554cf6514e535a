#include "R2/image_files/BmpRunLength.h"

#include <algorithm>

#include "R2/image_files/ByteReader.h"

namespace R2::bmp {
namespace {

// A move right and up takes four bytes and skips at most 255 rows of pixels, or 255 by 255 if rows are that short.
// Files with more pixels per byte would only waste memory.
constexpr std::uint64_t most_pixels_per_byte = 255 * 255 / 4;

class RunLengths {
 public:
  RunLengths(std::span<const unsigned char> pixels, const Header& header)
      : reader_("BMP", pixels),
        width_(header.size.width),
        height_(header.size.height),
        bits_(header.bits),
        row_end_(static_cast<int>(header.RowStride()) * 8 / header.bits),
        places_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

  Places Read() {
    bool is_done = false;
    while (!is_done && y_ < height_) {
      // Some writers omit the end mark.
      if (reader_.Left() < 2 && y_ == height_ - 1 && x_ >= width_) break;
      is_done = ReadCode();
    }
    Places read{std::move(places_), {}, 0};
    if (is_cut_) read.warnings.push_back("BMP is damaged: a run goes beyond its row or the image, and is cut there");
    const auto rest = reader_.Rest();
    const bool has_end = !is_done && rest.size() >= 2 && rest[0] == 0 && rest[1] == 1;
    read.bytes_behind = rest.size() - (has_end ? 2 : 0);
    return read;
  }

 private:
  /// Reads one code; returns true at the end of the bitmap.
  bool ReadCode() {
    const unsigned count = reader_.Byte("a run"), code = reader_.Byte("a run");
    if (count > 0) {
      Run(count, code);
    } else if (code == 0) {
      x_ = 0;
      ++y_;
    } else if (code == 2) {
      const int right = reader_.Byte("a step"), up = reader_.Byte("a step");
      is_cut_ |= right > row_end_ - x_ || up > height_ - 1 - y_;
      x_ = std::min(x_ + right, row_end_);
      y_ += up;
    } else if (code > 2) {
      Stretch(code);
    }
    return count == 0 && code == 1;
  }

  /// Repeats one byte: one palette index, or two in turn.
  void Run(unsigned count, unsigned value) {
    const unsigned first = bits_ == 4 ? value >> 4 : value, second = bits_ == 4 ? value & 15 : value;
    for (unsigned i = 0; i < count; ++i) Put(i % 2 == 0 ? first : second);
  }

  /// Copies literal indices, padded to an even number of bytes.
  void Stretch(unsigned count) {
    const unsigned bytes = bits_ == 4 ? (count + 1) / 2 : count;
    const auto places = reader_.Take(bytes, "a stretch");
    for (unsigned i = 0; i < count; ++i)
      Put(bits_ == 4 ? places[i / 2] >> (i % 2 == 0 ? 4 : 0) & 15 : static_cast<unsigned>(places[i]));
    if (bytes % 2 == 1 && reader_.Left() > 0) reader_.Take(1, "a stretch");
  }

  void Put(unsigned place) {
    if (x_ == row_end_) {
      is_cut_ = true;
      return;
    }
    const std::size_t row = static_cast<std::size_t>(y_) * static_cast<std::size_t>(width_);
    if (x_ < width_) places_[row + static_cast<std::size_t>(x_)] = static_cast<unsigned char>(place);
    ++x_;
  }

  ByteReader reader_;
  int width_, height_, bits_;
  int row_end_;  // some writers also encode the bytes that pad a row to a multiple of four
  std::vector<unsigned char> places_;
  int x_ = 0, y_ = 0;  // the next pixel; x is at most row_end_, and y is inside the image while a code is read
  bool is_cut_ = false;
};

}  // namespace

Places ReadRunLengths(std::span<const unsigned char> pixels, const Header& header) {
  const auto count = static_cast<std::uint64_t>(header.size.width) * static_cast<unsigned>(header.size.height);
  if (count > most_pixels_per_byte * pixels.size())
    throw ImageError("BMP is truncated: its " + std::to_string(header.size.width) + " x " +
                     std::to_string(header.size.height) + " pixels cannot come out of " +
                     std::to_string(pixels.size()) + " bytes");
  return RunLengths(pixels, header).Read();
}

}  // namespace R2::bmp
