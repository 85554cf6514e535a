// The report of rayimg diff on two folders.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "rayimg/FolderDiff.h"
#include "rayimg/tests/Rayimg.h"

namespace ray::rayimg {
namespace {

/// A bright disc off the center of a gradient: without any symmetry, in bytes.
R2::Image Scene(int width, int height) {
  R2::Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool is_disc = (x - 9) * (x - 9) + (y - 20) * (y - 20) < 40;
      image.Set(x, y,
                is_disc ? R2::Color{1, 120 / 255.0, 40 / 255.0}
                        : R2::Color{(20 + 2 * x) / 255.0, (30 + 3 * y) / 255.0, 60 / 255.0});
    }
  return image;
}

template <class Of>
R2::Image Made(int width, int height, const Of& of) {
  R2::Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.Set(x, y, of(x, y));
  return image;
}

struct TwoFolders : TemporaryFolder {
  TwoFolders() {
    std::filesystem::create_directory(*this / "mine");
    std::filesystem::create_directory(*this / "right");
  }
  Finished Diff(const Words& more = {}) const {
    return Rayimg(testing::With({"diff", *this / "mine", *this / "right"}, more));
  }
};

TEST(FolderDiff, NamesACauseForEachDifference) {
  NEEDS_RAYIMG();
  constexpr int w = 40, h = 32;
  const R2::Image r = Scene(w, h);
  const auto swapped = [](const R2::Color& c) { return R2::Color{c.b, c.g, c.r}; };
  const std::pair<const char*, R2::Image> cases[] = {
      {"upside_down", Made(w, h, [&](int x, int y) { return r.At(x, h - 1 - y); })},
      {"mirrored", Made(w, h, [&](int x, int y) { return r.At(w - 1 - x, y); })},
      {"half_turn", Made(w, h, [&](int x, int y) { return r.At(w - 1 - x, h - 1 - y); })},
      {"transposed", Made(h, w, [&](int x, int y) { return r.At(w - 1 - y, h - 1 - x); })},
      {"turned_left", Made(h, w, [&](int x, int y) { return r.At(y, h - 1 - x); })},
      {"turned_right", Made(h, w, [&](int x, int y) { return r.At(w - 1 - y, x); })},
      {"red_and_blue_swapped", Made(w, h, [&](int x, int y) { return swapped(r.At(x, y)); })},
      {"gamma", Made(w, h, [&](int x, int y) { return EncodeSrgb(r.At(x, y)); })},
      {"scaled", Made(w, h, [&](int x, int y) { return 0.5 * r.At(x, y); })},
      {"one_pixel", Made(w, h, [&](int x, int y) { return r.At(std::max(0, x - 1), y); })},
      {"half_a_pixel", Made(w, h, [&](int x, int y) { return 0.5 * (r.At(std::max(0, x - 1), y) + r.At(x, y)); })},
      {"wrapped", Made(w, h,
                       [&](int x, int y) {
                         return r.At(x, y).r < 1 ? r.At(x, y) : R2::Color{0.1, r.At(x, y).g, r.At(x, y).b};
                       })},
      {"rounding", Made(w, h,
                        [&](int x, int y) {
                          return r.At(x, y) + R2::Color{0, 1 / 255.0, 0};
                        })},
  };
  const TwoFolders folders;
  for (const auto& [name, image] : cases) {
    Save(folders / ("mine/" + std::string(name) + ".png"), image);
    Save(folders / ("right/" + std::string(name) + ".ppm"), r);
  }
  const auto json = nlohmann::json::parse(folders.Diff({"-json"}).output);
  EXPECT_EQ(json["images"].size(), std::size(cases));
  for (const auto& image : json["images"]) {
    ASSERT_TRUE(image["cause"].is_object()) << image;
    EXPECT_EQ(image["cause"]["name"].get<std::string>() + ".png", image["name"]) << image;
  }
}

TEST(FolderDiff, AFactorIsNamedEvenIfTheReferenceIsClamped) {
  NEEDS_RAYIMG();
  const R2::Image dark = Scene(40, 32);
  const TwoFolders folders;
  Save(folders / "mine/a.png", dark);
  Save(folders / "right/a.png", Made(40, 32, [&](int x, int y) { return 1.8 * dark.At(x, y); }));
  const auto json = nlohmann::json::parse(folders.Diff({"-json"}).output);
  EXPECT_EQ(json["images"][0]["cause"]["name"], "scaled_in_reference") << json;
}

TEST(FolderDiff, SortsByDifferenceAndLosesNothing) {
  NEEDS_RAYIMG();
  const TwoFolders folders;
  const R2::Image r = Scene(40, 32);
  for (const char* name : {"near", "far", "same", "bad", "size"})
    Save(folders / ("right/" + std::string(name) + ".png"), r);
  Save(folders / "right/absent.png", r);
  Save(folders / "mine/extra.png", r);
  Save(folders / "mine/same.bmp", r);
  Save(folders / "mine/near.png", Made(40, 32, [&](int x, int y) { return x == 3 ? R2::Color{} : r.At(x, y); }));
  Save(folders / "mine/far.png", Filled(40, 32, {1, 0, 1}));
  Save(folders / "mine/size.png", Scene(20, 16));
  WriteFile(folders / "mine/bad.png", "no image");
  const Finished done = folders.Diff();
  EXPECT_EQ(done.status, 3);
  std::size_t at = 0;
  for (const char* name :
       {"bad.png: ", "extra.png: there is no reference", "absent.png: there is no image",
        "size.png: has 20x16 pixels, the reference 40x32", "far.png", "near.png", "same.bmp: ", "7 images"}) {
    const std::size_t next = done.output.find(name, at);
    EXPECT_NE(next, std::string::npos) << name << "\n" << done.output;
    if (next != std::string::npos) at = next;
  }
}

TEST(FolderDiff, ThePageIsSelfContainedAndTheTableComplete) {
  NEEDS_RAYIMG();
  const TwoFolders folders;
  Save(folders / "right/a<b,c.png", Filled(8, 8, {0.5, 0.5, 0.5}));
  Save(folders / "mine/a<b,c.png", Filled(8, 8, {0.6, 0.5, 0.5}));
  const std::string page = folders / "page.html", table = folders / "table.csv";
  ASSERT_EQ(folders.Diff({"-html", page, "-csv", table}).status, 0);
  const std::string html = ReadFile(page), csv = ReadFile(table);
  EXPECT_TRUE(Has(html, "a&lt;b,c.png"));
  EXPECT_FALSE(Has(html, "<script")) << "scripts";
  EXPECT_FALSE(Has(html, "http")) << "nothing is loaded";
  std::size_t images = 0;
  for (std::size_t at = 0; (at = html.find("src=\"data:image/png;base64,", at)) != std::string::npos; ++at) ++images;
  EXPECT_EQ(images, 4u) << "two images, FLIP and the difference";
  EXPECT_EQ(std::ranges::count(csv, '\n'), 2);
  EXPECT_TRUE(Has(csv, "\n\"a<b,c.png\",")) << csv;
}

TEST(FolderDiff, NamesPairExactlyFirstAndAmbiguousOnesNever) {
  const auto pairs =
      PairsOf({"m/a.jpg", "m/a.png", "m/b.exr", "m/c.bmp", "m/c.ppm"}, {"r/a.png", "r/b.png", "r/c.png"});
  ASSERT_EQ(pairs.size(), 6u);
  EXPECT_EQ(pairs[0].image + pairs[0].reference, "m/a.pngr/a.png");
  EXPECT_EQ(pairs[1].image + pairs[1].reference, "m/b.exrr/b.png");
  for (std::size_t i = 2; i < pairs.size(); ++i) EXPECT_TRUE(pairs[i].image.empty() != pairs[i].reference.empty());
}

}  // namespace
}  // namespace ray::rayimg
