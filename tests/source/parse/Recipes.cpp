// The examples of docs/recipes.md work when pasted.

#include <gtest/gtest.h>

#include <fstream>

#include "tests/Project.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

/// Returns the indented parts of a page.
std::vector<std::string> Blocks(const std::filesystem::path& page) {
  std::vector<std::string> blocks;
  std::ifstream in(page);
  bool is_open = false;
  for (std::string line; std::getline(in, line);) {
    const bool is_code = line.starts_with("    ");
    if (is_code && !is_open) blocks.emplace_back();
    if (is_code) blocks.back() += line + "\n";
    is_open = is_code;
  }
  return blocks;
}

R2::Image ImageFrom(const Folder& folder, const std::string& text) {
  return project::Render(project::Stage(folder.Write("in.scn", text)), project::Sized(24)).image;
}

TEST(Recipes, EachIsReadAndChangesTheImage) {
  const std::vector<std::string> blocks = Blocks(project::Root() / "docs/recipes.md");
  ASSERT_GE(blocks.size(), 8u);
  const Folder folder;
  std::filesystem::copy(project::Root() / "scenes/textures", folder / "textures");
  const R2::Image base = ImageFrom(folder, blocks[0]);
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    const R2::Image image = ImageFrom(folder, blocks[0] + blocks[i]);
    int changed = 0;
    for (int y = 0; y < base.Height(); ++y)
      for (int x = 0; x < base.Width(); ++x) changed += !(image.At(x, y) == base.At(x, y));
    EXPECT_GT(changed, 20) << blocks[i];
  }
}

}  // namespace
}  // namespace ray
