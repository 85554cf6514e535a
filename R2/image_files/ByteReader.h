#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace R2 {

/// Reads forward through the bytes of an image file. Requests for more bytes than are left throw ImageError, so all
/// readers that use no library are built on it.
class ByteReader {
 public:
  /// Makes a reader of bytes that must outlive it; `kind` names the format in messages and must outlive it too.
  ByteReader(const char* kind, std::span<const unsigned char> bytes) : kind_(kind), bytes_(bytes) {}

  std::uint64_t Left() const { return bytes_.size() - position_; }
  std::span<const unsigned char> Rest() const { return bytes_.subspan(position_); }
  /// Throws unless `count` bytes are left; `what` names their contents in the message.
  void Need(std::uint64_t count, const char* what) const;

  std::span<const unsigned char> Take(std::uint64_t count, const char* what);
  std::uint8_t Byte(const char* what) { return Take(1, what)[0]; }
  std::uint16_t Little16(const char* what);
  std::uint32_t Little32(const char* what);
  std::uint32_t Big32(const char* what);
  std::int32_t LittleSigned32(const char* what) { return static_cast<std::int32_t>(Little32(what)); }

  /// Reads up to the next `end`, and skips that.
  std::string_view Until(char end, const char* what);

  // Words of the Netpbm family: separated by white space; # starts a comment up to the end of its line.
  void SkipSpace();
  std::string_view Word(const char* what);
  /// Reads a digit 0 or 1 after optional white space.
  bool Bit(const char* what);
  /// Reads a word that is an integer in [least, most].
  int WholeNumber(const char* what, int least, int most);
  /// Reads the single byte of white space that ends the magic number.
  void OneSpace();
  /// Reads the white space between the header and `pixel_bytes` of binary pixels: one byte. Some writers end the line
  /// in CR LF, or with blanks before its end. Since a pixel may look like white space, extra characters are skipped
  /// only if the file is longer by that many bytes.
  void SpaceBefore(std::uint64_t pixel_bytes);

  /// Throws an ImageError that starts with the format's name.
  [[noreturn]] void Fail(const std::string& message) const;

 private:
  const char* kind_;
  std::span<const unsigned char> bytes_;
  std::size_t position_ = 0;
};

}  // namespace R2
