#include "R2/LooksLike.h"

#include <gtest/gtest.h>

#include "tests/R2/image_bytes.h"

namespace R2 {
namespace {

std::string Look(std::string_view text) { return LooksLike(ToBytes(text)); }

// The first bytes of files as other programs wrote them: Pillow 13, ffmpeg 5.1, gzip, zip, g++ and MinGW.
TEST(LooksLike, FilesOfOtherProgramsAreNamed) {
  using namespace std::string_view_literals;
  EXPECT_EQ(Look("RIFF\x24\x00\x00\x00WEBPVP8 "sv), "a WebP image");
  EXPECT_EQ(Look("GIF89a\x07\x00"sv), "a GIF image");
  EXPECT_EQ(Look("II*\x00\x08\x00\x00\x00"sv), "a TIFF image");
  EXPECT_EQ(Look("MM\x00*\x00\x00\x00\x08"sv), "a TIFF image");
  EXPECT_EQ(Look("\x00\x00\x00 ftypavif\x00\x00\x00\x00"sv), "an AVIF image");
  EXPECT_EQ(Look("\x00\x00\x00\x0cjP  \x0d\x0a\x87\x0a"sv), "a JPEG 2000 image");
  EXPECT_EQ(Look("\xffO\xffQ\x00"sv), "a JPEG 2000 image");
  EXPECT_EQ(Look("qoif\x00\x00\x00\x07"sv), "a QOI image");
  EXPECT_EQ(Look("P7\nWIDTH 7\n"sv), "a PAM image");
  EXPECT_EQ(Look("\x1f\x8b\x08\x08"sv), "a file packed by gzip");
  EXPECT_EQ(Look("PK\x03\x04\x14\x00"sv), "a ZIP archive");
  EXPECT_EQ(Look("\x7f"
                 "ELF\x02\x01\x01"sv),
            "an object file or program (ELF)");
  EXPECT_EQ(Look("\x64\x86\x05\x00\x00\x00\x00\x00\x1c\x02\x00\x00\x12\x00\x00\x00\x00\x00\x04\x00"sv),
            "an object file of Windows");
  EXPECT_EQ(Look("ply\nformat ascii 1.0\n"sv), "a PLY mesh");
}

TEST(LooksLike, NamesFilesOfSupportedFormatsToo) {
  EXPECT_EQ(LooksLike(Format("png").encode(Image(1, 1), {}, {})), "a PNG image");
  EXPECT_EQ(LooksLike(Format("jpeg").encode(Image(1, 1), {}, {})), "a JPEG image");
  EXPECT_EQ(LooksLike(Format("hdr").encode(Image(1, 1), {}, {})), "a Radiance HDR image");
}

TEST(LooksLike, TextIsNamedByItsBeginning) {
  EXPECT_EQ(Look("<!DOCTYPE html>\n<html>"), "a web page (HTML)");
  EXPECT_EQ(Look("\xef\xbb\xbf \r\n<HTML lang=\"en\">"), "a web page (HTML)");
  EXPECT_EQ(Look("<head><title>404 Not Found"), "a web page (HTML)");
  EXPECT_EQ(Look("<svg xmlns="), "an SVG image");
  EXPECT_EQ(Look("<?xml version=\"1.0\"?>"), "an XML document");
  EXPECT_EQ(Look("version https://git-lfs.github.com/spec/v1\noid sha256:12"),
            "a Git LFS pointer (git lfs pull fetches the file itself)");
  EXPECT_EQ(Look("v 0 0 0\nv 1 0 0\n"), "text");
  EXPECT_EQ(Look("\xff\xfev\0 \0"), "UTF-16 text (save it as UTF-8)");
}

TEST(LooksLike, WhatIsNotKnownHasNoName) {
  EXPECT_EQ(Look(""), "");
  EXPECT_EQ(Look("\x01\x02\x03"), "");
  EXPECT_EQ(LooksLike(Bytes(1000)), "zeros alone (as a broken transfer leaves them)");
  EXPECT_EQ(LooksLike(Bytes(1000) + Bytes{1}), "");
}

// Nothing of the file itself goes into a message: it may steer a terminal.
TEST(LooksLike, TheErrorNamesTheActualFileType) {
  EXPECT_EQ(Complaint(ToBytes("<html>")).substr(0, 72),
            "unknown image format: the file looks like a web page (HTML); supported: ");
}

}  // namespace
}  // namespace R2
