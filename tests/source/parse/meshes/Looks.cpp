// Files with the names of meshes that are not meshes. files/looks/make.sh wrote them with other programs.

#include <gtest/gtest.h>

#include <filesystem>

#include "source/parse/meshes/MeshFormat.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

TEST(Looks, NonMeshFilesAreErrors) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(project::Root() / "tests/source/parse/meshes/files/looks")) {
    const std::string bytes = project::BytesOf(entry.path());
    ASSERT_FALSE(bytes.empty()) << entry.path();
    if (entry.path().extension() == ".sh") continue;
    ++files;
    Report report;
    for (const MeshFormat* format : MeshFormats())
      EXPECT_THROW(format->read({std::string("a") + format->extension, bytes}, report), SceneError)
          << entry.path() << format->extension;
  }
  EXPECT_EQ(files, 16);
}

}  // namespace
}  // namespace ray
