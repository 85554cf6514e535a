#include "source/app/report/Info.h"

#include <array>
#include <filesystem>
#include <fstream>

#include "R2/ImageFile.h"
#include "source/app/files/ReadInputs.h"
#include "source/app/options/FileNames.h"
#include "source/app/report/Memory.h"
#include "source/app/report/Messages.h"
#include "source/app/report/Resources.h"
#include "source/parse/Files.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"

namespace ray {
namespace {

[[noreturn]] void Refuse(const std::string& file, const std::string& reason) {
  throw SceneErrors({ErrorIn(file, reason)});
}

/// Rejects everything except files and pipes.
void RefuseUnreadable(const std::string& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) Refuse(file, "no such file");
  if (error) Refuse(file, error.message());
  if (std::filesystem::is_directory(status)) Refuse(file, "it is a folder");
  if (!std::filesystem::is_regular_file(status) && !std::filesystem::is_fifo(status))
    Refuse(file, "it is neither a regular file nor a pipe");
}

}  // namespace

std::vector<unsigned char> ReadBytes(const std::string& file) {
  if (file == standard_stream) {
    const std::string text = Contents(file);
    return {text.begin(), text.end()};
  }
  RefuseUnreadable(file);
  std::ifstream stream(file, std::ios::binary);
  std::vector<unsigned char> bytes;
  std::array<char, 65536> block{};
  while (stream.read(block.data(), block.size()), stream.gcount() > 0) {
    bytes.insert(bytes.end(), block.begin(), block.begin() + stream.gcount());
    if (bytes.size() > Files::max_bytes) Refuse(file, "it exceeds the limit of 1 GiB");  // a pipe may never end
  }
  if (!stream.eof()) Refuse(file, "the file cannot be read");
  return bytes;
}

R2::DecodedImage DecodeImageFile(const std::string& file, std::span<const unsigned char> bytes) {
  try {
    const R2::ImageSize size = R2::ReadImageSize(bytes);
    const std::int64_t needed = std::int64_t{3 * sizeof(float)} * size.width * size.height, limit = MemoryLimit(0);
    if (needed > limit - PeakMemory())
      Refuse(file, "decoding it takes " + std::to_string(needed >> 20) + " MiB, and this machine allows " +
                       std::to_string(limit >> 20) + " MiB in all");
    return R2::DecodeImage(bytes);
  } catch (const R2::ImageError& error) {
    Refuse(file, error.what());
  }
}

R2::DecodedImage ReadImageFile(const std::string& file) {
  R2::DecodedImage decoded = DecodeImageFile(file, ReadBytes(file));
  PrintWarnings(file, decoded.warnings);
  return decoded;
}

std::string ImageText(const std::string& file, const R2::ImageHeader& header) {
  std::string text = Escaped(file == standard_stream ? standard_input_name : file) + ": " + header.format->name + ", " +
                     std::to_string(header.size.width) + "x" + std::to_string(header.size.height) + "\n";
  for (const auto& [key, value] : header.settings) text += Escaped(key) + ": " + Escaped(value) + "\n";
  return text;
}

std::string ImageInfo(const std::string& file) {
  try {
    return ImageText(file, R2::ReadImageHeader(ReadBytes(file)));
  } catch (const R2::ImageError& error) {
    Refuse(file, error.what());
  }
}

}  // namespace ray
