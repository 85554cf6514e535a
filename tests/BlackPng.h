#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

/// A black PNG of 1 bit per pixel: about a thousandth of its pixels in bytes, and a small part of what it decodes to.
/// `more`: whole chunks behind the pixels.
inline std::string BlackPng(std::uint32_t columns, std::uint32_t rows, const std::string& more = {}) {
  const auto big = [](std::uint32_t number) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 255);
    return bytes;
  };
  const auto chunk = [&](const std::string& name_and_data) {
    const auto* bytes = reinterpret_cast<const Bytef*>(name_and_data.data());
    const uLong crc = crc32(0, bytes, static_cast<uInt>(name_and_data.size()));
    return big(static_cast<std::uint32_t>(name_and_data.size() - 4)) + name_and_data +
           big(static_cast<std::uint32_t>(crc));
  };
  const std::vector<Bytef> lines(std::size_t{1 + (columns + 7) / 8} * rows);
  std::vector<Bytef> packed(compressBound(lines.size()));
  uLongf length = packed.size();
  compress2(packed.data(), &length, lines.data(), lines.size(), 9);
  const std::string header = big(columns) + big(rows) + std::string("\x01\0\0\0\0", 5);
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR" + header) +
         chunk("IDAT" + std::string(reinterpret_cast<const char*>(packed.data()), length)) + more + chunk("IEND");
}
