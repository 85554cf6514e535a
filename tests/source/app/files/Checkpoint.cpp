#include "source/app/files/Checkpoint.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;

// Regression: it stayed in the temporary folder although the image was finished.
TEST(Checkpoint, ACopyKeptElsewhereIsRemovedOnceSavedOrFinished) {
  const TemporaryFolder refuge, folder;
  setenv("TMPDIR", refuge.Path().c_str(), 1);
  FileOptions files;
  files.image = folder / "out.ppm";
  Checkpoint checkpoint(files, {}, false);
  const auto fail = [&] {
    fs::remove(folder / "out.ppm.checkpoint");
    fs::create_directories(fs::path(folder / "out.ppm.checkpoint") / "full");  // no file can have this name now
    checkpoint.Save({}, "scene");
    EXPECT_EQ(refuge.Others({}).size(), 1u);
    fs::remove_all(folder / "out.ppm.checkpoint");
  };
  fail();
  checkpoint.Save({}, "scene");
  EXPECT_EQ(refuge.Others({}), std::vector<std::string>{});
  EXPECT_EQ(folder.Others({}), std::vector<std::string>{"out.ppm.checkpoint"});
  fail();
  checkpoint.Remove();
  EXPECT_EQ(refuge.Others({}), std::vector<std::string>{});
  EXPECT_EQ(folder.Others({}), std::vector<std::string>{});
  unsetenv("TMPDIR");
}

}  // namespace
}  // namespace ray::testing
