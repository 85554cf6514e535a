#include "source/text/FileLook.h"

#include <algorithm>
#include <cstddef>

#include "source/text/LowerCase.h"

namespace ray {
namespace {

using namespace std::string_view_literals;

struct Beginning {
  std::string_view bytes;  // in lower case where letters may be in any
  FileLook look;
};

constexpr const char* unpack = "unpack it first";
constexpr const char* compiled = "the extension .obj also means a compiler's output";

// Sources: the formats' own descriptions, and the database of file(1).
constexpr Beginning beginnings[] = {
    {"version https://git-lfs"sv, {"a Git LFS pointer", "'git lfs pull' fetches the file itself"}},
    {"\x7F\x45LF"sv, {"an ELF object file or program", compiled}},
    {"!<arch>\n"sv, {"a library of object files", compiled}},
    {"\xCF\xFA\xED\xFE"sv, {"a Mach-O object file or program", compiled}},
    {"MZ"sv, {"a Windows program", ""}},
    {"PK\3\4"sv, {"a ZIP archive", unpack}},
    {"\x1F\x8B"sv, {"a file compressed by gzip", unpack}},
    {"BZh"sv, {"a file compressed by bzip2", unpack}},
    {"\xFD\x37zXZ"sv, {"a file compressed by xz", unpack}},
    {"7z\xBC\xAF\x27\x1C"sv, {"a 7-Zip archive", unpack}},
    {"Rar!"sv, {"a RAR archive", unpack}},
    {"glTF"sv, {"a glTF model", "export it as OBJ, PLY or STL"}},
    {"Kaydara FBX"sv, {"an FBX model", "export it as OBJ, PLY or STL"}},
    {"BLENDER"sv, {"a Blender file", "export it as OBJ, PLY or STL"}},
    {"#VRML"sv, {"a VRML model", "export it as OBJ, PLY or STL"}},
    {"ISO-10303-21"sv, {"a STEP model", "export it as STL"}},
    {"%PDF"sv, {"a PDF", ""}},
    {"\x89PNG"sv, {"a PNG image", ""}},
    {"\xFF\xD8\xFF"sv, {"a JPEG image", ""}},
    {"{\\rtf"sv, {"a document of a word processor", "save it as plain text"}},
    {"ply\n"sv, {"a PLY mesh", "give it the extension .ply"}},
    {"ply\r"sv, {"a PLY mesh", "give it the extension .ply"}},
    {"OFF\n"sv, {"an OFF mesh", "give it the extension .off"}},
    {"OFF\r"sv, {"an OFF mesh", "give it the extension .off"}},
};

// Web pages and the like, whose letters may be in any case.
constexpr Beginning markup[] = {
    {"<!doctype html"sv, {"a web page", "what was to be downloaded may need another address"}},
    {"<html"sv, {"a web page", "what was to be downloaded may need another address"}},
    {"<head"sv, {"a web page", "what was to be downloaded may need another address"}},
    {"<?xml"sv, {"an XML document", "COLLADA and X3D are not supported; export it as OBJ, PLY or STL"}},
    {"<"sv, {"a web page or XML document", ""}},
    {"{"sv, {"a JSON document", ""}},
};

/// The header of the object files of Microsoft's compilers: which processor, few sections, a symbol table within the
/// file, and no optional header.
bool IsCoff(std::string_view bytes) {
  if (bytes.size() < 20) return false;
  const auto number = [&](std::size_t offset) {
    return static_cast<unsigned char>(bytes[offset]) + 256u * static_cast<unsigned char>(bytes[offset + 1]);
  };
  constexpr unsigned machines[] = {0x14C, 0x8664, 0xAA64, 0x1C4};
  if (std::ranges::find(machines, number(0)) == std::end(machines)) return false;
  const std::size_t symbols = number(8) + 65536 * std::size_t{number(10)};
  return number(2) < 10'000 && symbols < bytes.size() && number(16) == 0;
}

/// With its mark, or with a NUL in every other byte of the first eight, as Latin letters have there.
bool IsUtf16(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
  if (bytes.size() < 8) return false;
  const auto are_nul = [&](std::size_t first, bool nul) {
    for (std::size_t i = first; i < 8; i += 2)
      if ((bytes[i] == '\0') != nul) return false;
    return true;
  };
  return (are_nul(0, true) && are_nul(1, false)) || (are_nul(0, false) && are_nul(1, true));
}

}  // namespace

FileLook LookOf(std::string_view bytes) {
  if (IsUtf16(bytes)) return {"UTF-16 text", "save it as UTF-8"};
  if (IsCoff(bytes)) return {"a COFF object file", compiled};
  for (const Beginning& beginning : beginnings)
    if (bytes.starts_with(beginning.bytes)) return beginning.look;
  const std::size_t first = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first == std::string_view::npos) return {nullptr, ""};
  for (const Beginning& beginning : markup)
    if (BeginsInAnyCase(bytes.substr(first), beginning.bytes)) return beginning.look;
  if (BeginsInAnyCase(bytes.substr(first), "solid ")) return {"an STL mesh", "give it the extension .stl"};
  return {nullptr, ""};
}

}  // namespace ray
