// Scripts for users that need programs of others; tests/app/movie.txt has those that need none.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

TEST(ParallelScript, NamesAreNeverPatterns) {
  NEEDS_THE_PROGRAM();
  if (std::system("command -v parallel > /dev/null") != 0) GTEST_SKIP() << "there is no GNU parallel here";
  for (const std::string name : {"shot[1].png", "s{}h{1}{.}.png", "a\\nb\\\\.png", "a *b?.png"}) {
    const TemporaryFolder place;
    WriteFile(place / "in {} [1].scn", small_scene);
    const std::string script = (std::filesystem::canonical(project::Root()) / "script/farm/parallel.sh").string(),
                      command = "cd '" + place.Path().string() + "' && '" + script + "' -parts 3 'in {} [1].scn' '" +
                                name + "' -width 16 -height 12 -samples 2 > said 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << name << ReadFile(place / "said");
    EXPECT_EQ(place.Others({"in {} [1].scn", "said", name}), nothing);
    EXPECT_EQ(Decode(place / name).image.Width(), 16) << name;
  }
}

}  // namespace
}  // namespace ray::testing
