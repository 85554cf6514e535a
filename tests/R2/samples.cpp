// Image files by other programs, small ones of every common kind. Their contents, and the words of the warnings, are in
// samples/expected.txt, from other readers; samples/README.md explains it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/Project.h"
#include "tests/R2/image_bytes.h"

namespace R2 {
namespace {

namespace fs = std::filesystem;

struct Sample {
  std::string file{}, error{}, warning{};
  int width = 0, height = 0;
  double unit = 1, tolerance = 0;  // pixels are multiples of 1/unit, and so is the tolerance
  std::vector<Color> pixels{};     // from the top left
};

fs::path Folder() { return project::Root() / "tests/R2/samples"; }

Bytes ReadSample(const std::string& name) {
  std::ifstream stream(Folder() / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Parses "r,g,b", or one number for gray.
Color ReadColor(const std::string& word) {
  Color c;
  char comma = 0;
  std::istringstream stream(word);
  if (stream >> c.r && !(stream >> comma >> c.g >> comma >> c.b)) c.g = c.b = c.r;
  return c;
}

void TakePixels(Sample& sample, const Sample& other) {
  sample.width = other.width;
  sample.height = other.height;
  sample.pixels = other.pixels;
}

std::vector<Sample> ReadSamples() {
  std::ifstream stream(Folder() / "expected.txt");
  std::vector<Sample> samples;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string key, rest;
    words >> key;
    std::getline(words >> std::ws, rest);
    if (key == "file") samples.push_back({.file = rest});
    if (key == "error") samples.back().error = rest;
    if (key == "warning") samples.back().warning = rest;
    if (key == "unit") samples.back().unit = std::stod(rest);
    if (key == "tolerance") samples.back().tolerance = std::stod(rest);
    if (key == "as") TakePixels(samples.back(), *std::ranges::find(samples, rest, &Sample::file));
    if (key == "size") std::istringstream(rest) >> samples.back().width >> samples.back().height;
    if (key.find_first_not_of("-0123456789.,e+") != std::string::npos || key.empty()) continue;
    std::istringstream pixels(line);
    for (std::string pixel; pixels >> pixel;) samples.back().pixels.push_back(ReadColor(pixel));
  }
  return samples;
}

/// Returns true if this build reads the format of a sample.
bool IsRead(const Sample& sample) { return FormatForName("a.exr") || !sample.file.ends_with(".exr"); }

void ExpectPixels(const Image& image, const Sample& sample) {
  ASSERT_EQ(image.Width(), sample.width);
  ASSERT_EQ(image.Height(), sample.height);
  ASSERT_EQ(sample.pixels.size(), static_cast<std::size_t>(sample.width) * static_cast<std::size_t>(sample.height));
  double largest = 0;
  for (std::size_t i = 0; i < sample.pixels.size(); ++i) {
    const int column = static_cast<int>(i) % sample.width, row = static_cast<int>(i) / sample.width;
    const Color difference = image.At(column, sample.height - 1 - row) * sample.unit - sample.pixels[i];
    largest = std::max({largest, std::abs(difference.r), std::abs(difference.g), std::abs(difference.b)});
  }
  // An image stores floats, and the text has nine digits.
  EXPECT_LE(largest, sample.tolerance + 1e-7 * std::max(sample.unit, 4.0));
}

/// Expects exactly one warning, with the given words.
void ExpectWarning(const DecodedImage& decoded, const std::string& words) {
  ASSERT_EQ(decoded.warnings.size(), words.empty() ? 0u : 1u) << (decoded.warnings.empty() ? "" : decoded.warnings[0]);
  if (words.empty()) return;
  EXPECT_NE(decoded.warnings[0].find(words), std::string::npos) << decoded.warnings[0];
}

// An image that all other programs show differently is wrong.
TEST(Samples, AreReadAsOthersReadThem) {
  int read = 0;
  for (const Sample& sample : ReadSamples()) {
    SCOPED_TRACE(sample.file);
    if (!IsRead(sample) || !sample.error.empty()) continue;
    const Bytes bytes = ReadSample(sample.file);
    try {
      const DecodedImage decoded = DecodeImage(bytes);
      ExpectPixels(decoded.image, sample);
      ExpectWarning(decoded, sample.warning);
      const ImageSize size = ReadImageSize(bytes);
      EXPECT_EQ(size.width, decoded.image.Width());
      EXPECT_EQ(size.height, decoded.image.Height());
      ++read;
    } catch (const ImageError& error) {
      ADD_FAILURE() << error.what();
    }
  }
  EXPECT_GE(read, 70);
}

TEST(Samples, ThatCannotBeReadAreRefusedWithTheReason) {
  for (const Sample& sample : ReadSamples()) {
    if (sample.error.empty() || !IsRead(sample)) continue;
    const std::string complaint = Complaint(ReadSample(sample.file));
    EXPECT_NE(complaint.find(sample.error), std::string::npos) << sample.file << ": " << complaint;
  }
}

TEST(Samples, AreAllListed) {
  const std::vector<Sample> samples = ReadSamples();
  for (const auto& entry : fs::directory_iterator(Folder())) {
    const std::string name = entry.path().filename().string();
    if (name == "expected.txt" || name == "README.md") continue;
    EXPECT_EQ(std::ranges::count(samples, name, &Sample::file), 1) << name;
  }
}

// A download that is interrupted anywhere in one of them.
TEST(Samples, CutShortAreRefusedOrKeepTheirSize) {
  for (const Sample& sample : ReadSamples()) {
    const Bytes bytes = ReadSample(sample.file);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      try {
        const Image image = DecodeImage({bytes.data(), length}).image;
        EXPECT_EQ(image.Width(), sample.width) << sample.file << " cut to " << length;
      } catch (const ImageError& error) {
        EXPECT_STRNE(error.what(), "");
      }
    }
  }
}

}  // namespace
}  // namespace R2
