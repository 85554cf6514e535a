#include "R2/image_files/Orientation.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace R2 {
namespace {

/// A reader of the numbers of a TIFF file, in the byte order that it states.
class TiffNumbers {
 public:
  explicit TiffNumbers(std::span<const unsigned char> bytes) : bytes_(bytes), is_big_(Starts("MM")) {}

  bool IsTiff() const { return (Starts("II") || Starts("MM")) && At(2, 2) == 42u; }

  /// Returns the number of `count` bytes at `place`; std::nullopt beyond the end.
  std::optional<std::uint32_t> At(std::uint64_t place, unsigned count) const {
    if (place > bytes_.size() || count > bytes_.size() - place) return {};
    std::uint32_t number = 0;
    for (unsigned i = 0; i < count; ++i)
      number = number << 8 | bytes_[static_cast<std::size_t>(place) + (is_big_ ? i : count - 1 - i)];
    return number;
  }

 private:
  bool Starts(std::string_view letters) const {
    return bytes_.size() >= letters.size() && std::equal(letters.begin(), letters.end(), bytes_.begin());
  }

  std::span<const unsigned char> bytes_;
  bool is_big_;
};

/// Returns the value of the orientation in the first directory, whose entries are tag, type, count and value.
std::optional<std::uint32_t> OrientationNumber(const TiffNumbers& tiff) {
  constexpr std::uint32_t orientation_tag = 0x112, short_type = 3, entry_bytes = 12;
  if (!tiff.IsTiff()) return {};
  const std::uint64_t directory = tiff.At(4, 4).value_or(0);
  const std::uint32_t entries = tiff.At(directory, 2).value_or(0);
  for (std::uint32_t i = 0; i < entries; ++i) {
    const std::uint64_t entry = directory + 2 + std::uint64_t{entry_bytes} * i;
    const auto tag = tiff.At(entry, 2);
    if (!tag) return {};
    if (*tag == orientation_tag) return tiff.At(entry + 2, 2) == short_type ? tiff.At(entry + 8, 2) : std::nullopt;
  }
  return {};
}

}  // namespace

Orientation ExifOrientation(std::span<const unsigned char> exif) {
  // The position of row 0 and column 0: top left, top right, bottom right, bottom left, and with rows and columns
  // swapped left top, right top, right bottom, left bottom.
  constexpr std::array<Orientation, 8> orientations{{{},
                                                     {false, true, false},
                                                     {false, true, true},
                                                     {false, false, true},
                                                     {true, false, false},
                                                     {true, true, false},
                                                     {true, true, true},
                                                     {true, false, true}}};
  const std::uint32_t number = OrientationNumber(TiffNumbers(exif)).value_or(1);
  return number >= 1 && number <= orientations.size() ? orientations[number - 1] : Orientation{};
}

ImageSize Turned(ImageSize size, const Orientation& orientation) {
  if (orientation.rows_are_columns) std::swap(size.width, size.height);
  return size;
}

void Turn(DecodedImage& decoded, const Orientation& orientation) {
  if (orientation == Orientation{}) return;
  const Image& stored = decoded.image;
  const ImageSize size = Turned(ImageSize{stored.Width(), stored.Height()}, orientation);
  Image turned(size.width, size.height);
  for (int row = 0; row < stored.Height(); ++row)
    for (int column = 0; column < stored.Width(); ++column) {
      const int from_left = orientation.rows_are_columns ? row : column;
      const int from_top = orientation.rows_are_columns ? column : row;
      const int x = orientation.from_right ? size.width - 1 - from_left : from_left;
      const int y = orientation.from_bottom ? from_top : size.height - 1 - from_top;
      turned.Set(x, y, stored.At(column, stored.Height() - 1 - row));
    }
  decoded.image = std::move(turned);
  decoded.is_turned = true;
}

}  // namespace R2
