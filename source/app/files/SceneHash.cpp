#include "source/app/files/SceneHash.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <sstream>

#include "source/parse/Files.h"
#include "source/text/Hash.h"

namespace ray {
namespace {

void Add(std::istream& bytes, Hash& hash) {
  std::array<unsigned char, 65536> block{};
  do {
    bytes.read(reinterpret_cast<char*>(block.data()), block.size());
    hash.Add(std::span(block).first(static_cast<std::size_t>(bytes.gcount())));
  } while (bytes);
}

std::string Hexadecimal(std::uint64_t number) {
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += "0123456789abcdef"[number >> shift & 15];
  return text;
}

}  // namespace

std::string SceneHash(std::span<const std::string> files, std::span<const std::string_view> texts) {
  Hash hash;
  for (const std::string_view text : texts)
    hash.Add(std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size()));
  for (const std::string& file : files.subspan(texts.size())) {
    if (file == standard_input_name) {
      std::istringstream bytes(StandardInput());
      Add(bytes, hash);
      continue;
    }
    std::ifstream bytes(file, std::ios::binary);
    Add(bytes, hash);
  }
  return Hexadecimal(hash.Value());
}

}  // namespace ray
