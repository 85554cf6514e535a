#include "R2/image_files/ByteReader.h"

#include <algorithm>
#include <charconv>

#include "R2/ImageFile.h"

namespace R2 {
namespace {

bool IsSpace(unsigned char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

std::string_view Text(std::span<const unsigned char> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

void ByteReader::Need(std::uint64_t count, const char* what) const {
  if (count <= Left()) return;
  Fail("is truncated: " + std::string(what) + " takes " + std::to_string(count) + " bytes, but only " +
       std::to_string(Left()) + " are left");
}

std::span<const unsigned char> ByteReader::Take(std::uint64_t count, const char* what) {
  Need(count, what);
  const auto taken = bytes_.subspan(position_, static_cast<std::size_t>(count));
  position_ += taken.size();
  return taken;
}

std::uint16_t ByteReader::Little16(const char* what) {
  const auto b = Take(2, what);
  return static_cast<std::uint16_t>(b[0] | b[1] << 8);
}

std::uint32_t ByteReader::Little32(const char* what) {
  const std::uint32_t low = Little16(what), high = Little16(what);
  return low | high << 16;
}

std::uint32_t ByteReader::Big32(const char* what) {
  const auto b = Take(4, what);
  return std::uint32_t{b[0]} << 24 | std::uint32_t{b[1]} << 16 | std::uint32_t{b[2]} << 8 | std::uint32_t{b[3]};
}

std::string_view ByteReader::Until(char end, const char* what) {
  const auto rest = bytes_.subspan(position_);
  const auto found = std::find(rest.begin(), rest.end(), static_cast<unsigned char>(end));
  if (found == rest.end()) Fail("is truncated inside " + std::string(what));
  const auto length = static_cast<std::size_t>(found - rest.begin());
  position_ += length + 1;
  return Text(rest.first(length));
}

void ByteReader::SkipSpace() {
  while (Left() > 0 && (IsSpace(bytes_[position_]) || bytes_[position_] == '#')) {
    const bool is_comment = bytes_[position_] == '#';
    ++position_;
    // A lone carriage return also ends a line.
    while (is_comment && Left() > 0 && bytes_[position_] != '\n' && bytes_[position_] != '\r') ++position_;
  }
}

std::string_view ByteReader::Word(const char* what) {
  SkipSpace();
  const std::size_t start = position_;
  while (Left() > 0 && !IsSpace(bytes_[position_]) && bytes_[position_] != '#') ++position_;
  if (start == position_) Fail("is truncated: " + std::string(what) + " is missing");
  return Text(bytes_.subspan(start, position_ - start));
}

bool ByteReader::Bit(const char* what) {
  SkipSpace();
  const std::uint8_t digit = Byte(what);
  if (digit != '0' && digit != '1') Fail("is wrong: " + std::string(what) + " must be 0 or 1");
  return digit == '1';
}

int ByteReader::WholeNumber(const char* what, int least, int most) {
  const std::string_view word = Word(what);
  int number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  // The message does not quote the word: it comes from an untrusted file and may be long or contain terminal control
  // codes.
  if (error != std::errc() || end != word.data() + word.size() || number < least || number > most) {
    Fail("is wrong: " + std::string(what) + " must be a whole number from " + std::to_string(least) + " to " +
         std::to_string(most));
  }
  return number;
}

void ByteReader::OneSpace() {
  if (!IsSpace(Byte("the header"))) Fail("header lacks required white space");
}

void ByteReader::SpaceBefore(std::uint64_t pixel_bytes) {
  const std::size_t start = position_;
  OneSpace();
  if (bytes_[start] == '\n' || Left() <= pixel_bytes) return;
  std::size_t end = position_;
  while (end < bytes_.size() && (bytes_[end] == ' ' || bytes_[end] == '\t' || bytes_[end] == '\r')) ++end;
  if (end == bytes_.size() || bytes_[end] != '\n') return;
  ++end;
  // CR LF is a line end even if surplus bytes follow.
  const bool is_windows_line = bytes_[start] == '\r' && end == start + 2;
  if (is_windows_line || bytes_.size() - end == pixel_bytes) position_ = end;
}

void ByteReader::Fail(const std::string& message) const { throw ImageError(std::string(kind_) + " " + message); }

}  // namespace R2
