// rayimg movie, tested on the bytes of its files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "rayimg/tests/Rayimg.h"

namespace ray::rayimg {
namespace {

/// A small reader of RIFF that follows the specification and shares no code with the writer.
struct Riff {
  std::string bytes;

  std::string Letters(std::size_t at) const { return bytes.substr(at, 4); }
  std::size_t Number(std::size_t at, std::size_t count = 4) const {
    std::size_t number = 0;
    for (std::size_t i = count; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes.at(at + i));
    return number;
  }

  /// Returns the start of the content of the chunk at a path such as "hdrl/strl/strh", or nothing if the path leads to
  /// no chunk or if chunks do not exactly fill the chunk that contains them.
  std::optional<std::size_t> Find(const std::string& path) const { return Find(path, 12, 8 + Number(4)); }
  std::optional<std::size_t> Find(const std::string& path, std::size_t at, std::size_t end) const {
    std::optional<std::size_t> found;
    const std::string name = path.substr(0, 4);
    while (at < end) {
      const bool is_list = Letters(at) == "LIST";
      const std::size_t size = Number(at + 4), content = at + 8;
      if (!found && (is_list ? Letters(content) : Letters(at)) == name) {
        found = path.size() > 4 ? Find(path.substr(5), content + 4, content + size) : content;
        if (!found) return {};
      }
      at = content + size + size % 2;
    }
    return at == end ? found : std::nullopt;
  }
};

/// Different frames, at least one of them of an odd number of bytes.
Words SaveFrames(const TemporaryFolder& folder, int count) {
  Words names;
  bool is_any_odd = false;
  for (int i = 0; i < count || !is_any_odd; ++i) {
    R2::Image image = Filled(24, 16, {0.1 * (i % 10), 0.5, 0.2});
    for (int k = 0; k <= i % 16; ++k) image.Set(k, k, {1, 0.05 * k, 0});
    names.push_back(Save(folder / ("frame" + std::to_string(i) + ".jpg"), image, {{"frame", std::to_string(i)}}));
    is_any_odd = is_any_odd || ReadFile(names.back()).size() % 2 == 1;
  }
  return names;
}

TEST(RayimgMovie, TheHeadersStateSizeSpeedAndNumberOfFrames) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const Words frames = SaveFrames(folder, 3);
  std::size_t largest = 0;
  for (const std::string& frame : frames) largest = std::max(largest, ReadFile(frame).size());
  Words words{"movie", folder / "out.avi", "-fps", "12.5"};
  words.insert(words.end(), frames.begin(), frames.end());
  const Finished done = Rayimg(words);
  ASSERT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(done.output + done.error, "");

  const Riff avi{ReadFile(folder / "out.avi")};
  EXPECT_EQ(avi.Letters(0) + avi.Letters(8), "RIFFAVI ");
  EXPECT_EQ(avi.Number(4), avi.bytes.size() - 8);
  const auto movie = avi.Find("hdrl/avih"), stream = avi.Find("hdrl/strl/strh"), format = avi.Find("hdrl/strl/strf");
  ASSERT_TRUE(movie && stream && format);
  EXPECT_EQ(avi.Number(*movie - 4), 56u);
  EXPECT_EQ(avi.Number(*movie), 80000u) << "microseconds a frame";
  EXPECT_EQ(avi.Number(*movie + 12), 0x10u) << "that there is an index";
  EXPECT_EQ(avi.Number(*movie + 16), frames.size());
  EXPECT_EQ(avi.Number(*movie + 24), 1u) << "streams";
  EXPECT_GE(avi.Number(*movie + 28), largest) << "players set this much aside";
  EXPECT_EQ(avi.Number(*movie + 32), 24u);
  EXPECT_EQ(avi.Number(*movie + 36), 16u);
  EXPECT_EQ(avi.Number(*stream - 4), 56u);
  EXPECT_EQ(avi.Letters(*stream) + avi.Letters(*stream + 4), "vidsMJPG");
  EXPECT_EQ(static_cast<double>(avi.Number(*stream + 24)) / static_cast<double>(avi.Number(*stream + 20)), 12.5);
  EXPECT_EQ(avi.Number(*stream + 32), frames.size());
  EXPECT_GE(avi.Number(*stream + 36), largest);
  EXPECT_EQ(avi.Number(*stream + 52, 2), 24u);
  EXPECT_EQ(avi.Number(*stream + 54, 2), 16u);
  EXPECT_EQ(avi.Number(*format - 4), 40u);
  EXPECT_EQ(avi.Number(*format), 40u);
  EXPECT_EQ(avi.Number(*format + 4), 24u);
  EXPECT_EQ(avi.Number(*format + 8), 16u);
  EXPECT_EQ(avi.Letters(*format + 16), "MJPG");
}

// Found in two ways: from chunk to chunk, like a player that plays, and through the index, like one that seeks.
TEST(RayimgMovie, ChunksAndIndexContainEveryFramesJpeg) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  Words frames = SaveFrames(folder, 5);
  frames.push_back(frames.front());
  Words words{"movie", folder / "out.avi"};
  words.insert(words.end(), frames.begin(), frames.end());
  ASSERT_EQ(Rayimg(words).status, 0);

  const Riff avi{ReadFile(folder / "out.avi")};
  const auto movie = avi.Find("movi"), index = avi.Find("idx1");
  ASSERT_TRUE(movie && index);
  EXPECT_EQ(avi.Number(*avi.Find("hdrl/strl/strh") + 24), 25 * avi.Number(*avi.Find("hdrl/strl/strh") + 20));
  EXPECT_EQ(avi.Number(*index - 4), 16 * frames.size());
  std::size_t at = *movie + 4;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::string jpeg = ReadFile(frames[i]);
    EXPECT_EQ(avi.Letters(at), "00dc") << i;
    ASSERT_EQ(avi.Number(at + 4), jpeg.size()) << i;
    EXPECT_EQ(avi.bytes.substr(at + 8, jpeg.size()), jpeg) << i;
    const std::size_t line = *index + 16 * i;
    EXPECT_EQ(avi.Letters(line), "00dc") << i;
    EXPECT_EQ(avi.Number(line + 4), 0x10u) << "a frame that needs no other, " << i;
    EXPECT_EQ(*movie + avi.Number(line + 8), at) << i;
    EXPECT_EQ(avi.Number(line + 12), jpeg.size()) << i;
    at += 8 + jpeg.size() + jpeg.size() % 2;
  }
  EXPECT_EQ(at, *movie + avi.Number(*movie - 4)) << "the list holds the frames and nothing else";
}

}  // namespace
}  // namespace ray::rayimg
