#include "R2/LooksLike.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace R2 {

namespace {

using namespace std::string_view_literals;

struct Signature {
  std::size_t place;
  std::string_view bytes;
  const char* name;
};

// Longer ones first where one starts like another.
constexpr std::array signatures{
    Signature{0, "\x89PNG\r\n\x1a\n"sv, "a PNG image"},
    Signature{0, "\x89PNG"sv, "a PNG image whose line ends were changed (as by a transfer as text)"},
    Signature{0, "\xff\xd8\xff"sv, "a JPEG image"},
    Signature{0, "GIF8"sv, "a GIF image"},
    Signature{8, "WEBP"sv, "a WebP image"},
    Signature{4, "ftypavif"sv, "an AVIF image"},
    Signature{4, "ftypheic"sv, "a HEIC image"},
    Signature{4, "ftypmif1"sv, "a HEIF image"},
    Signature{4, "ftypjxl "sv, "a JPEG XL image"},
    Signature{4, "ftyp"sv, "a movie (MP4)"},
    Signature{0, "\xff\x0a"sv, "a JPEG XL image"},
    Signature{4, "JXL \r\n"sv, "a JPEG XL image"},
    Signature{4, "jP  \r\n"sv, "a JPEG 2000 image"},
    Signature{0, "\xff\x4f\xff\x51"sv, "a JPEG 2000 image"},
    Signature{0, "II*\0"sv, "a TIFF image"},
    Signature{0, "MM\0*"sv, "a TIFF image"},
    Signature{0, "II+\0"sv, "a TIFF image"},
    Signature{0, "II\xbc\x01"sv, "a JPEG XR image"},
    Signature{0, "\x76\x2f\x31\x01"sv, "an OpenEXR image"},
    Signature{0, "#?RADIANCE"sv, "a Radiance HDR image"},
    Signature{0, "#?RGBE"sv, "a Radiance HDR image"},
    Signature{0, "8BPS"sv, "a Photoshop image"},
    Signature{0, "DDS "sv, "a DDS image"},
    Signature{0, "\xabKTX"sv, "a KTX image"},
    Signature{0, "qoif"sv, "a QOI image"},
    Signature{0, "P7\n"sv, "a PAM image"},
    Signature{0, "gimp xcf"sv, "a GIMP image"},
    Signature{0, "\0\0\1\0"sv, "an icon"},
    Signature{0, "%PDF"sv, "a PDF document"},
    Signature{0, "%!PS"sv, "a PostScript document"},
    Signature{0, "PK\3\4"sv, "a ZIP archive"},
    Signature{0, "\x1f\x8b"sv, "a file packed by gzip"},
    Signature{0, "BZh"sv, "a file packed by bzip2"},
    Signature{0,
              "\xfd"
              "7zXZ"sv,
              "a file packed by xz"},
    Signature{0, "\x28\xb5\x2f\xfd"sv, "a file packed by zstd"},
    Signature{0, "7z\xbc\xaf\x27\x1c"sv, "a 7z archive"},
    Signature{0, "Rar!"sv, "a RAR archive"},
    Signature{257, "ustar"sv, "a tar archive"},
    Signature{0, "BLENDER"sv, "a Blender file"},
    Signature{0, "glTF"sv, "a glTF scene"},
    Signature{0, "Kaydara FBX"sv, "an FBX scene"},
    Signature{0, "ply\n"sv, "a PLY mesh"},
    Signature{0, "ply\r"sv, "a PLY mesh"},
    Signature{0,
              "\x7f"
              "ELF"sv,
              "an object file or program (ELF)"},
    Signature{0, "\xcf\xfa\xed\xfe"sv, "an object file or program (Mach-O)"},
    Signature{0, "MZ"sv, "a program of Windows"},
    Signature{0, "\xff\xfe"sv, "UTF-16 text (save it as UTF-8)"},
    Signature{0, "\xfe\xff"sv, "UTF-16 text (save it as UTF-8)"},
};

// What text starts with, in any letter case, behind a byte order mark and white space.
constexpr std::array beginnings_of_text{
    Signature{0, "version https://git-lfs"sv, "a Git LFS pointer (git lfs pull fetches the file itself)"},
    Signature{0, "<!doctype html"sv, "a web page (HTML)"},
    Signature{0, "<html"sv, "a web page (HTML)"},
    Signature{0, "<head"sv, "a web page (HTML)"},
    Signature{0, "<svg"sv, "an SVG image"},
    Signature{0, "<?xml"sv, "an XML document"},
};

char Lowered(unsigned char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); }

bool Has(std::span<const unsigned char> bytes, const Signature& signature) {
  if (bytes.size() < signature.place + signature.bytes.size()) return false;
  const auto there = bytes.subspan(signature.place, signature.bytes.size());
  return std::equal(there.begin(), there.end(), signature.bytes.begin(),
                    [](unsigned char a, char b) { return a == static_cast<unsigned char>(b); });
}

bool IsSpace(unsigned char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Whether it starts like an object file of Windows, which is called .obj as meshes are: the processor, few sections,
/// and no optional header.
bool IsWindowsObject(std::span<const unsigned char> bytes) {
  constexpr std::size_t header_size = 20;
  if (bytes.size() < header_size) return false;
  const bool is_known_processor = (bytes[0] == 0x64 && bytes[1] == 0x86) || (bytes[0] == 0x4c && bytes[1] == 0x01) ||
                                  (bytes[0] == 0x64 && bytes[1] == 0xaa);
  return is_known_processor && bytes[3] == 0 && bytes[16] == 0 && bytes[17] == 0;
}

std::span<const unsigned char> WithoutByteOrderMark(std::span<const unsigned char> bytes) {
  const bool has_mark = bytes.size() >= 3 && bytes[0] == 0xef && bytes[1] == 0xbb && bytes[2] == 0xbf;
  return has_mark ? bytes.subspan(3) : bytes;
}

/// By the text that begins it; also plain text.
std::string LooksLikeText(std::span<const unsigned char> bytes) {
  constexpr std::size_t looked_at = 512;
  bytes = WithoutByteOrderMark(bytes.first(std::min(looked_at, bytes.size())));
  const auto is_text = [](unsigned char c) { return c >= 0x80 || (c >= ' ' && c != 0x7f) || IsSpace(c); };
  if (bytes.empty() || !std::ranges::all_of(bytes, is_text)) return {};
  const auto first = std::ranges::find_if_not(bytes, IsSpace);
  for (const Signature& beginning : beginnings_of_text) {
    const auto ends = std::ranges::mismatch(std::span(first, bytes.end()), beginning.bytes, {}, Lowered);
    if (ends.in2 == beginning.bytes.end()) return beginning.name;
  }
  return "text";
}

}  // namespace

std::string LooksLike(std::span<const unsigned char> bytes) {
  for (const Signature& signature : signatures)
    if (Has(bytes, signature)) return signature.name;
  if (IsWindowsObject(bytes)) return "an object file of Windows";
  if (!bytes.empty() && std::ranges::all_of(bytes, [](unsigned char c) { return c == 0; }))
    return "zeros alone (as a broken transfer leaves them)";
  return LooksLikeText(bytes);
}

}  // namespace R2
