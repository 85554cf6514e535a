#include "source/app/report/Check.h"

#include <gtest/gtest.h>

#include "source/app/files/SceneHash.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray {
namespace {

using testing::TemporaryFolder;
using testing::WriteFile;

TEST(Check, InsideTheBoundsIsNotInsideTheSolid) {
  const project::Stage example(project::FromText("sphere -1  0.9 0.9 9.9  1.5\n"));
  EXPECT_EQ(SolidsAround(example.world, {0, 0, 9}), 0) << "in a corner of its box";
  EXPECT_EQ(SolidsAround(example.world, {0.9, 0.9, 9.9}), 1);
}

TEST(Check, BeingInsideFollowsTheTransformsOfTheGraph) {
  const project::Stage example(
      project::FromText("begin -1  2 0 0 5  0 2 0 0  0 0 2 0  0 0 0 1\nsphere -1  0 0 0  1\nend\n"));
  EXPECT_EQ(SolidsAround(example.world, {6.5, 0, 0}), 1);
  EXPECT_EQ(SolidsAround(example.world, {0.5, 0, 0}), 0);
}

// Whether a point is inside a sphere is computed without rays.
TEST(Check, InsideASphereIsNearerThanItsRadius) {
  const project::Stage example(project::FromText("sphere -1  0.25 -0.5 0.125  1\n"));
  for (int i = 0; i < 1000; ++i) {
    const R3::Point p{-1.3 + 0.26 * (i % 10) + 0.01, -1.3 + 0.26 * (i / 10 % 10) + 0.02,
                      -1.3 + 0.26 * (i / 100) + 0.03};
    const R3::Vector d = p - R3::Point{0.25, -0.5, 0.125};
    EXPECT_EQ(SolidsAround(example.world, p), Dot(d, d) < 1 ? 1 : 0) << p.x << " " << p.y << " " << p.z;
  }
}

// The published test vectors of the hash, so that another program can check an image's scene.
TEST(SceneHash, IsFnv1a64) {
  const TemporaryFolder folder;
  EXPECT_EQ(SceneHash(std::vector{WriteFile(folder / "empty", "")}), "cbf29ce484222325");
  EXPECT_EQ(SceneHash(std::vector{WriteFile(folder / "a", "a")}), "af63dc4c8601ec8c");
  EXPECT_EQ(SceneHash(std::vector{WriteFile(folder / "foobar", "foobar")}), "85944171f73967e8");
}

TEST(SceneHash, CoversAllFilesAndEveryByte) {
  const TemporaryFolder folder;
  const std::string foo = WriteFile(folder / "foo", "foo"), bar = WriteFile(folder / "bar", "bar");
  EXPECT_EQ(SceneHash(std::vector{foo, bar}), "85944171f73967e8");
  WriteFile(folder / "long", std::string(65536, 'x'));
  const std::string before = SceneHash(std::vector{folder / "long"});
  WriteFile(folder / "long", std::string(65535, 'x') + "y");
  EXPECT_NE(SceneHash(std::vector{folder / "long"}), before);
}

}  // namespace
}  // namespace ray
