#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "R2/ImageFile.h"
#include "tests/Folder.h"
#include "tests/Project.h"
#include "tests/source/view/Contrast.h"

namespace {

using Attributes = std::map<std::string, std::string>;

struct Tag {
  std::string name;
  Attributes attributes;
};

/// The opening tags of a page as our own generator writes them: values in double quotes, no > within them.
std::vector<Tag> TagsOf(const std::string& page) {
  std::vector<Tag> tags;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
    if (!std::isalpha(static_cast<unsigned char>(page[at + 1]))) continue;
    const std::size_t end = page.find('>', at);
    std::size_t i = page.find_first_of(" >", at);
    Tag tag{page.substr(at + 1, i - at - 1), {}};
    while (i < end) {
      i = page.find_first_not_of(" \n", i);
      const std::size_t stop = page.find_first_of("= >", i);
      if (stop >= end || page[stop] != '=') break;  // what is left is a word without a value
      const std::size_t close = page.find('"', stop + 2);
      tag.attributes[page.substr(i, stop - i)] = page.substr(stop + 2, close - stop - 2);
      i = close + 1;
    }
    tags.push_back(std::move(tag));
  }
  return tags;
}

std::filesystem::path Writeup() { return project::Root() / "writeup"; }

constexpr const char* pages[] = {"assignment3.html", "shapes.html",   "light.html",
                                 "surfaces.html",    "camera.html",   "viewer.html",
                                 "accuracy.html",    "courses.html",  "troubleshooting.html"};

/// The ids of a page of the writeup.
std::set<std::string> IdsOf(const std::string& page) {
  std::set<std::string> ids;
  for (const Tag& tag : TagsOf(project::BytesOf(Writeup() / page)))
    if (tag.attributes.contains("id")) ids.insert(tag.attributes.at("id"));
  return ids;
}

/// True if a link of a page leads to a file, and to an id of a page if it names one.
bool IsThere(const std::string& page, const std::string& link) {
  const std::size_t sign = std::min(link.find('#'), link.size());
  const std::string file = sign == 0 ? page : link.substr(0, sign);
  if (!std::filesystem::is_regular_file(Writeup() / file)) return false;
  return sign == link.size() || IdsOf(file).contains(link.substr(sign + 1));
}

TEST(Writeup, EveryLinkAndImageOfThePagesExists) {
  for (const std::string page : pages) {
    const std::string text = project::BytesOf(Writeup() / page);
    ASSERT_FALSE(text.empty()) << page;
    int links = 0;
    for (const Tag& tag : TagsOf(text))
      for (const char* name : {"href", "src"}) {
        if (!tag.attributes.contains(name)) continue;
        const std::string& link = tag.attributes.at(name);
        ++links;
        EXPECT_EQ(link.find("//"), std::string::npos) << page << " would ask a network for " << link;
        if (link.starts_with("data:")) continue;
        EXPECT_TRUE(IsThere(page, link)) << page << " links to " << link;
      }
    EXPECT_GT(links, 20) << page;
  }
}

TEST(Writeup, IdsAreUniqueAndImagesHaveAltTextAndSize) {
  int all_images = 0;
  for (const std::string page : pages) {
    std::set<std::string> ids;
    int images = 0;
    for (const Tag& tag : TagsOf(project::BytesOf(Writeup() / page))) {
      if (tag.attributes.contains("id")) {
        EXPECT_TRUE(ids.insert(tag.attributes.at("id")).second) << page << ": " << tag.attributes.at("id");
      }
      if (tag.name != "img") continue;
      ++images;
      const std::string src = tag.attributes.contains("src") ? tag.attributes.at("src") : "";
      EXPECT_TRUE(tag.attributes.contains("alt") && !tag.attributes.at("alt").empty()) << page << ": " << src;
      ASSERT_TRUE(tag.attributes.contains("width") && tag.attributes.contains("height")) << page << ": " << src;
      if (src.ends_with(".svg")) continue;
      // A browser keeps the room that the page says; a wrong proportion would squeeze the picture.
      const std::string bytes = project::BytesOf(Writeup() / src);
      const auto size = R2::ReadImageSize({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
      const int width = std::stoi(tag.attributes.at("width")), height = std::stoi(tag.attributes.at("height"));
      EXPECT_EQ(width * size.height, height * size.width) << page << ": " << src;
    }
    EXPECT_GT(images, 2) << page;
    all_images += images;
  }
  EXPECT_GT(all_images, 150);
}

TEST(Writeup, StoredImagesAreListedAndSmallAltogether) {
  const std::string table = project::BytesOf(project::Root() / "script" / "pictures.txt");
  std::uintmax_t bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(Writeup() / "pictures")) {
    bytes += entry.file_size();
    const std::string id = entry.path().stem();
    if (entry.path().extension() == ".svg") continue;
    EXPECT_NE(table.find("\n" + id + " | "), std::string::npos) << entry.path() << " is made by nothing";
  }
  EXPECT_LT(bytes, 9'000'000u);
}

/// "#8ab8f5", or a variable of the theme: "--link".
ray::contrast::Color ColorNamed(const std::string& theme, const std::string& name) {
  std::string code = name;
  if (name.starts_with("--")) {
    const std::size_t at = theme.find(name + ": #");
    if (at == std::string::npos) throw std::runtime_error("no " + name + " in " + theme);
    code = theme.substr(at + name.size() + 2, std::string("#rrggbb").size());
  }
  const auto channel = [&](std::size_t i) { return std::stoi(code.substr(1 + 2 * i, 2), nullptr, 16) / 255.0; };
  return {channel(0), channel(1), channel(2)};
}

TEST(Writeup, LettersAreReadInTheLightAndInTheDark) {
  const std::string style = project::BytesOf(Writeup() / "style.css");
  const std::size_t light = style.find(":root {"), dark = style.find(":root {", light + 1);
  ASSERT_NE(dark, std::string::npos);
  for (const std::size_t at : {light, dark}) {
    const std::string theme = style.substr(at, style.find('}', at) - at);
    for (const char* ink : {"--ink", "--soft", "--link"})
      for (const char* ground : {"--paper", "--panel"})
        EXPECT_GE(ray::contrast::Between(ColorNamed(theme, ink), ColorNamed(theme, ground)), ray::contrast::of_text)
            << ink << " on " << ground << " of " << theme;
  }
  EXPECT_NE(style.find("color: #ffffff; background: #1d2127"), std::string::npos) << "labels of compared pictures";
  EXPECT_GE(ray::contrast::Between(ColorNamed("", "#ffffff"), ColorNamed("", "#1d2127")), ray::contrast::of_text);
}

}  // namespace
