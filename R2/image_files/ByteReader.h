#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace R2 {

/// Reads forward through the bytes of an image file. Whatever asks for more than is left throws ImageError,
/// which is why every reader without a library behind it goes through here.
class ByteReader {
 public:
  /// `kind` names the format in messages. Both are only looked at, and must outlive the reader.
  ByteReader(const char* kind, std::span<const unsigned char> bytes) : kind_(kind), bytes_(bytes) {}

  std::uint64_t Left() const { return bytes_.size() - position_; }
  std::span<const unsigned char> Rest() const { return bytes_.subspan(position_); }
  /// Throws unless `count` bytes are left, `what` being what they hold.
  void Need(std::uint64_t count, const char* what) const;

  std::span<const unsigned char> Take(std::uint64_t count, const char* what);
  std::uint8_t Byte(const char* what) { return Take(1, what)[0]; }
  std::uint16_t Little16(const char* what);
  std::uint32_t Little32(const char* what);
  std::uint32_t Big32(const char* what);
  std::int32_t LittleSigned32(const char* what) { return static_cast<std::int32_t>(Little32(what)); }

  /// The bytes before the next `end`, which is passed over.
  std::string_view Until(char end, const char* what);

  // Words of the Netpbm family: separated by white space; # starts a comment that goes on to the end of its line.
  void SkipSpace();
  std::string_view Word(const char* what);
  /// A digit 0 or 1, before which there may be white space.
  bool Bit(const char* what);
  /// A word that is a whole number in [least, most].
  int WholeNumber(const char* what, int least, int most);
  /// The one byte of white space that ends the magic number.
  void OneSpace();
  /// The white space between the header and `pixel_bytes` of binary pixels: one byte. Some writers end the line in CR
  /// LF, or with blanks before its end. Since a pixel may look like white space, these are passed over only where the
  /// file is longer for them.
  void SpaceBefore(std::uint64_t pixel_bytes);

  /// Throws an ImageError that starts with the kind.
  [[noreturn]] void Fail(const std::string& message) const;

 private:
  const char* kind_;
  std::span<const unsigned char> bytes_;
  std::size_t position_ = 0;
};

}  // namespace R2
