#ifdef RAYPRO_EXR

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

#include "source/app/report/Info.h"
#include "tests/Project.h"
#include "tests/R2/image_bytes.h"

namespace R2 {

namespace {

class Stream : public Imf::OStream {
 public:
  Stream() : OStream("test") {}
  void write(const char from[], int count) override {
    const auto length = static_cast<std::size_t>(count);
    bytes.resize(std::max(bytes.size(), position + length));
    std::memcpy(bytes.data() + position, from, length);
    position += length;
  }
  std::uint64_t tellp() override { return position; }
  void seekp(std::uint64_t to) override { position = to; }

  Bytes bytes;
  std::size_t position = 0;
};

constexpr int width = 5, height = 3;

/// Makes a header for 5 by 3 pixels, all of the image, whose windows are not at the origin.
Imf::Header OffsetHeader() {
  const Imath::Box2i window({-2, 10}, {-2 + width - 1, 10 + height - 1});
  return Imf::Header(window, window);
}

/// Returns the value of the pixel `x` from the left and `y` from the top, exact as a half.
half Value(int x, int y, int channel) { return half(static_cast<float>(100 * channel + 10 * y + x) - 7.5f); }

struct Pixels {
  explicit Pixels(const std::vector<std::string>& channels, Imf::Header& header) {
    const int count = static_cast<int>(channels.size());
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < count; ++c) values.push_back(Value(x, y, c));
    const std::size_t stride = sizeof(half) * channels.size();
    for (std::size_t c = 0; c < channels.size(); ++c) {
      header.channels().insert(channels[c], Imf::Channel(Imf::HALF));
      frame.insert(channels[c],
                   Imf::Slice::Make(Imf::HALF, values.data() + c, header.dataWindow(), stride, stride * width));
    }
  }
  std::vector<half> values;
  Imf::FrameBuffer frame;
};

Bytes ScanLines(const std::vector<std::string>& channels, Imf::Compression compression,
                Imf::LineOrder order = Imf::INCREASING_Y) {
  Imf::Header header = OffsetHeader();
  header.compression() = compression;
  header.lineOrder() = order;
  const Pixels pixels(channels, header);
  Stream stream;
  {
    Imf::OutputFile file(stream, header, 0);
    file.setFrameBuffer(pixels.frame);
    file.writePixels(height);
  }
  return stream.bytes;
}

Bytes Tiles(unsigned tile) {
  Imf::Header header = OffsetHeader();
  header.setTileDescription(Imf::TileDescription(tile, tile, Imf::ONE_LEVEL));
  const Pixels pixels({"R", "G", "B"}, header);
  Stream stream;
  {
    Imf::TiledOutputFile file(stream, header, 0);
    file.setFrameBuffer(pixels.frame);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  }
  return stream.bytes;
}

void ExpectTheValues(const Bytes& bytes, bool is_gray = false) {
  const Image image = DecodeImage(bytes).image;
  ASSERT_EQ(image.Width(), width);
  ASSERT_EQ(image.Height(), height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Color c = image.At(x, height - 1 - y);
      EXPECT_EQ(c.r, float{Value(x, y, 0)});
      EXPECT_EQ(c.g, float{Value(x, y, is_gray ? 0 : 1)});
      EXPECT_EQ(c.b, float{Value(x, y, is_gray ? 0 : 2)});
    }
}

/// Returns the start of the value of a header's attribute.
std::size_t ValueOf(const Bytes& bytes, const std::string& name, const std::string& type) {
  const std::string both = name + '\0' + type + '\0';
  const auto found = std::search(bytes.begin(), bytes.end(), both.begin(), both.end());
  return static_cast<std::size_t>(found - bytes.begin()) + both.size() + 4;
}

void SetLittle(Bytes& bytes, std::size_t at, std::uint32_t number) {
  for (std::size_t i = 0; i < 4; ++i) bytes.at(at + i) = static_cast<unsigned char>(number >> 8 * i);
}

}  // namespace

TEST(Exr, ReadsHalvesInEveryLosslessCompressionAndLineOrder) {
  for (const auto compression : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
                                 Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION}) {
    SCOPED_TRACE(compression);
    ExpectTheValues(ScanLines({"R", "G", "B"}, compression));
    ExpectTheValues(ScanLines({"R", "G", "B"}, compression, Imf::DECREASING_Y));
  }
}

TEST(Exr, TilesAreReadWhetherTheyFitOrNot) {
  for (const unsigned tile : {1u, 2u, 4u, 64u}) ExpectTheValues(Tiles(tile));
}

TEST(Exr, LuminanceAloneIsGrayAndOtherChannelsAreSkipped) {
  ExpectTheValues(ScanLines({"Y"}, Imf::ZIP_COMPRESSION), true);
  ExpectTheValues(ScanLines({"R", "G", "B", "A", "Z"}, Imf::ZIP_COMPRESSION));
  EXPECT_EQ(Complaint(ScanLines({"Z"}, Imf::ZIP_COMPRESSION)),
            "EXR has neither the channels R, G and B nor Y; it has Z");
  EXPECT_EQ(Complaint(ScanLines({"a", "b", "c", "d", "e", "f", "g", "h"}, Imf::ZIP_COMPRESSION)),
            "EXR has neither the channels R, G and B nor Y; it has a, b, c, d, e, f and 2 more");
}

// Compressions that this build's library does not know yet.
TEST(Exr, NewerCompressionsAreNamed) {
  Bytes bytes = ScanLines({"R", "G", "B"}, Imf::ZIP_COMPRESSION);
  for (const auto& [method, name] :
       {std::pair<unsigned char, const char*>{10, "method 10 (HTJ2K256)"}, {200, "method 200,"}}) {
    bytes.at(ValueOf(bytes, "compression", "compression")) = method;
    EXPECT_NE(Complaint(bytes).find(name), std::string::npos) << Complaint(bytes);
  }
}

TEST(Exr, FloatsComeBackBitForBit) {
  Image image(3, 1);
  image.Set(0, 0, {1.0f / 3, -1e-42f, 3.4e38f});
  EXPECT_EQ(DecodeImage(Format("exr").encode(image, {}, {})).image, image);
}

// K3, K5: sizes that the library would trust.
TEST(Exr, HeadersThatStateTooMuchAreRefused) {
  const Bytes plain = Format("exr").encode(Gradient(9, 3), {}, {});
  const std::size_t window = ValueOf(plain, "dataWindow", "box2i");
  for (const std::uint32_t most : {0x7fffffffu, 65534u, 0x80000000u}) {
    Bytes bytes = plain;
    SetLittle(bytes, window + 8, most);
    SetLittle(bytes, window + 12, most);
    EXPECT_EQ(Complaint(bytes).substr(0, 11), "EXR states ") << Complaint(bytes);
  }
  Bytes tall = plain;
  SetLittle(tall, window + 8, 0);
  SetLittle(tall, window + 12, (1u << 28) - 1);
  EXPECT_NE(Complaint(tall).find("the table of blocks takes 134217728 bytes"), std::string::npos) << Complaint(tall);

  Bytes attribute = plain;
  SetLittle(attribute, ValueOf(plain, "compression", "compression") - 4, 0x7fffffff);
  EXPECT_NE(Complaint(attribute).find("an attribute takes 2147483647 bytes"), std::string::npos);

  Bytes tiled = Tiles(2);
  SetLittle(tiled, ValueOf(tiled, "tiles", "tiledesc"), 0x7fffffff);
  EXPECT_NE(Complaint(tiled).find("tiles much larger"), std::string::npos);
}

struct Windows {
  const char* file;
  int left, top, right, bottom;                              // of the image, inclusive
  int stored_left, stored_top, stored_right, stored_bottom;  // of the stored pixels
  bool is_gray = false;
};

// Compositing programs store the known part of a frame, or more than the frame. The files come from exr/write.py.
TEST(Exr, TheDisplayWindowIsBlackWhereNothingIsStored) {
  for (const Windows& w : {Windows{"within.exr", 0, 0, 7, 4, 2, 1, 5, 3},
                           {"beyond.exr", 1, 2, 4, 4, -2, -1, 8, 6},
                           {"aside.exr", -1, -2, 5, 3, -3, 1, 2, 9},
                           {"apart.exr", 0, 0, 3, 1, 10, 10, 12, 11},
                           {"gray.exr", -2, -1, 2, 2, -1, 0, 1, 1, true},
                           {"tiled.exr", 0, 0, 4, 6, 1, -1, 6, 4}}) {
    SCOPED_TRACE(w.file);
    const Bytes bytes = ray::ReadBytes((project::Root() / "tests/R2/exr" / w.file).string());
    const ImageSize size = ReadImageSize(bytes);
    const Image image = DecodeImage(bytes).image;
    ASSERT_EQ(size.width, w.right - w.left + 1);
    ASSERT_EQ(size.height, w.bottom - w.top + 1);
    ASSERT_EQ(image.Width(), size.width);
    ASSERT_EQ(image.Height(), size.height);
    for (int y = w.top; y <= w.bottom; ++y)
      for (int x = w.left; x <= w.right; ++x) {
        const bool is_stored = x >= w.stored_left && x <= w.stored_right && y >= w.stored_top && y <= w.stored_bottom;
        const double value = x + 10 * y;
        const Color expected =
            is_stored ? Color{value, value + (w.is_gray ? 0 : 0.25), value + (w.is_gray ? 0 : 0.5)} : Color{};
        EXPECT_EQ(image.At(x - w.left, w.bottom - y), expected) << x << " " << y;
      }
  }
}

TEST(Exr, ThatHoldsForLuminanceAndChromaToo) {
  for (const char* file : {"chroma.exr", "chroma-full.exr", "chroma-from-bottom.exr"}) {
    SCOPED_TRACE(file);
    Bytes bytes = ray::ReadBytes((project::Root() / "tests/R2/samples" / file).string());
    const Image whole = DecodeImage(bytes).image;
    const std::size_t data = ValueOf(bytes, "dataWindow", "box2i"), display = ValueOf(bytes, "displayWindow", "box2i");
    ASSERT_TRUE(std::equal(bytes.begin() + static_cast<std::ptrdiff_t>(data),
                           bytes.begin() + static_cast<std::ptrdiff_t>(data + 16),
                           bytes.begin() + static_cast<std::ptrdiff_t>(display)));
    constexpr int aside = 3, down = 2;  // by which the image is offset from the stored pixels
    for (const std::size_t corner : {std::size_t{0}, std::size_t{8}}) {
      std::array<std::int32_t, 2> at;
      std::memcpy(at.data(), &bytes[display + corner], sizeof at);
      SetLittle(bytes, display + corner, static_cast<std::uint32_t>(at[0] + aside));
      SetLittle(bytes, display + corner + 4, static_cast<std::uint32_t>(at[1] + down));
    }
    const Image moved = DecodeImage(bytes).image;
    ASSERT_EQ(moved.Width(), whole.Width());
    ASSERT_EQ(moved.Height(), whole.Height());
    for (int y = 0; y < whole.Height(); ++y)
      for (int x = 0; x < whole.Width(); ++x) {
        const bool is_stored = x + aside < whole.Width() && y - down >= 0;
        EXPECT_EQ(moved.At(x, y), is_stored ? whole.At(x + aside, y - down) : Color{}) << x << " " << y;
      }
  }
}

// Pixels that are not stored take no bytes of the file, and could require any amount of memory.
TEST(Exr, AnImageOfMostlyMarginIsRefusedBeforeAllocating) {
  const Bytes plain = Format("exr").encode(Gradient(9, 3), {}, {});
  const std::size_t window = ValueOf(plain, "displayWindow", "box2i");
  const auto displayed = [&](std::uint32_t right, std::uint32_t bottom) {
    Bytes bytes = plain;
    SetLittle(bytes, window + 8, right);
    SetLittle(bytes, window + 12, bottom);
    return bytes;
  };
  for (const std::uint32_t most : {0x7fffffffu, 65534u, 0x80000000u})
    EXPECT_EQ(Complaint(displayed(most, most)).substr(0, 11), "EXR states ");
  EXPECT_EQ(Complaint(displayed(16383, 16383)), "EXR has 9 x 3 pixels for an image of 16384 x 16384");
  EXPECT_EQ(Complaint(displayed((1u << 26), 0)), "EXR has 9 x 3 pixels for an image of 67108865 x 1");
  EXPECT_EQ(Complaint(displayed(99, 9)), "");
  const ImageSize size = ReadImageSize(displayed(8191, 8191));
  EXPECT_EQ(size.width, 8192);
  EXPECT_EQ(size.height, 8192);
}

TEST(Exr, AHeaderWithoutADisplayWindowIsRefused) {
  Bytes bytes = Format("exr").encode(Gradient(9, 3), {}, {});
  bytes.at(ValueOf(bytes, "displayWindow", "box2i") - 4 - 6 - 1 - 2) = 'x';
  EXPECT_EQ(Complaint(bytes), "EXR has no display window");
}

// The library would read the attributes after one of a wrong size from wrong positions, and allocate any size found
// there.
TEST(Exr, AttributesOfTheWrongSizeAreRefused) {
  const Bytes plain = ScanLines({"R", "G", "B"}, Imf::ZIP_COMPRESSION);
  for (const auto& [name, type] : {std::pair<std::string, std::string>{"channels", "chlist"},
                                   {"dataWindow", "box2i"},
                                   {"pixelAspectRatio", "float"},
                                   {"screenWindowCenter", "v2f"}}) {
    const std::size_t value = ValueOf(plain, name, type);
    Bytes longer(plain.begin(), plain.begin() + static_cast<std::ptrdiff_t>(value));
    ++longer[value - 4];
    longer = longer + Bytes{0} + Bytes(plain.begin() + static_cast<std::ptrdiff_t>(value), plain.end());
    EXPECT_EQ(Complaint(longer), "EXR has an attribute whose size is not that of its type") << name;
  }
  const auto with = [&](const std::string& type, const Bytes& value) {
    const Bytes attribute = ToBytes("x") + Bytes{0} + ToBytes(type) + Bytes{0} +
                            Bytes{static_cast<unsigned char>(value.size()), 0, 0, 0} + value;
    return Complaint(Bytes(plain.begin(), plain.begin() + 8) + attribute + Bytes(plain.begin() + 8, plain.end()));
  };
  EXPECT_NE(with("preview", {255, 255, 255, 0, 255, 1, 0, 0}).find("a preview takes"), std::string::npos);
  EXPECT_NE(with("stringvector", {255, 255, 255, 127}).find("a text takes"), std::string::npos);
}

// A header that states wide rows costs nothing while only the header is read.
TEST(Extremes, K3_AnExrHeaderIsReadWithoutAllocatingRows) {
  Bytes bytes = ScanLines({"R", "G", "B"}, Imf::ZIP_COMPRESSION);
  for (const char* window : {"dataWindow", "displayWindow"}) {
    const std::size_t left = ValueOf(bytes, window, "box2i"), right = left + 8;
    SetLittle(bytes, left, 0);
    SetLittle(bytes, right, (1u << 26) - 1);
  }
  const auto address_space = [] {
    std::ifstream pages("/proc/self/statm");
    long count = 0;
    pages >> count;
    return count * 4096;
  };
  const long before = address_space();
  rlimit limit = {};
  getrlimit(RLIMIT_AS, &limit);
  const rlimit tight = {static_cast<rlim_t>(before) + (rlim_t{1} << 28), limit.rlim_max};
  setrlimit(RLIMIT_AS, &tight);
  EXPECT_EQ(ReadImageHeader(bytes).size.width, 1 << 26);
  setrlimit(RLIMIT_AS, &limit);
}

// The library would return uninitialized memory as the missing pixels.
TEST(Exr, ABlockWithFewerPixelsThanTheWindowIsRefused) {
  for (const auto compression : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
                                 Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION}) {
    for (const int side : {0, 1}) {
      Bytes bytes = ScanLines({"R", "G", "B"}, compression);
      const std::size_t far_corner = ValueOf(bytes, "dataWindow", "box2i") + 8;
      SetLittle(bytes, far_corner + 4 * static_cast<std::size_t>(side), static_cast<std::uint32_t>(side ? 14 : 7));
      EXPECT_NE(Complaint(bytes), "") << compression << " " << side;
    }
  }
}

TEST(Exr, AMissingRowIsNotFilledUp) {
  Bytes bytes = Format("exr").encode(Gradient(9, 40), {}, {});
  bytes.resize(bytes.size() - 10);
  EXPECT_NE(Complaint(bytes).find("32 of 40 rows are present"), std::string::npos) << Complaint(bytes);
}

}  // namespace R2

#endif
