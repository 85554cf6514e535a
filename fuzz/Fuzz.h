#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>

#include "source/accelerate/World.h"
#include "source/parse/Parse.h"

/// What the fuzz targets share. A target is one file of this folder that defines LLVMFuzzerTestOneInput: it gives a
/// parser bytes from a stranger, and whatever the parser does other than to read them or to throw what it documents is
/// a finding.
namespace fuzz {

using Bytes = std::span<const unsigned char>;

inline Bytes BytesOf(const std::string& text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

/// A file of its own for this process, in memory where the system has such a folder; written anew for each input.
inline std::string FileOf(const std::string& name, Bytes bytes) {
  namespace fs = std::filesystem;
  static const fs::path folder = [] {
    const fs::path parent = fs::exists("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path();
    std::string unique = (parent / "raypro-fuzz-XXXXXX").string();
    if (!mkdtemp(unique.data())) std::abort();
    return fs::path(unique);
  }();
  const fs::path file = folder / name;
  std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
  return file.string();
}

/// Reads a scene and flattens it; limits are low, so that inputs stay fast.
inline int ReadScene(const std::string& extension, const std::string& format, Bytes bytes) {
  ray::ParseOptions options;
  options.format = format;
  options.max_nodes = 1 << 12;
  options.max_texture_bytes = 1 << 24;
  try {
    const ray::ParsedScene parsed = ray::Parse(FileOf("input." + extension, bytes), options);
    const ray::World world(parsed.scene);
  } catch (const ray::SceneErrors&) {
  }
  return 0;
}

}  // namespace fuzz

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size);
