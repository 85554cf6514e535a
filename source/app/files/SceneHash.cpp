#include "source/app/files/SceneHash.h"

#include <array>
#include <cstdint>
#include <fstream>

namespace ray {
namespace {

std::uint64_t HashOn(std::uint64_t hash, std::istream& bytes) {
  constexpr std::uint64_t prime = 0x100000001b3;
  std::array<char, 65536> block{};
  do {
    bytes.read(block.data(), block.size());
    for (const char c : std::span(block).first(static_cast<std::size_t>(bytes.gcount())))
      hash = (hash ^ static_cast<unsigned char>(c)) * prime;
  } while (bytes);
  return hash;
}

std::string Hexadecimal(std::uint64_t number) {
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[number >> shift & 15];
  return text;
}

}  // namespace

std::string SceneHash(std::span<const std::string> files) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::string& file : files) {
    std::ifstream bytes(file, std::ios::binary);
    hash = HashOn(hash, bytes);
  }
  return Hexadecimal(hash);
}

}  // namespace ray
