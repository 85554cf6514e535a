#include "source/app/GuardedMain.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;

// Regression: with fewer, a signal ended the process.
TEST(Extremes, L12_OneThreadDoesTheWorkIfNoneCanBeCreated) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder folder;
  std::filesystem::permissions(folder.Path(), std::filesystem::perms::all);
  Surroundings alone;
  alone.deny_threads = true;
  alone.environment["ASAN_OPTIONS"] = "detect_leaks=0";  // AddressSanitizer needs a thread to detect leaks
  if (RunProgram({"-version"}, alone).status != 0) GTEST_SKIP() << "the program is not for other users";
  const std::string scene = WriteFile(folder / "ball.scn", "sphere -1  0 0 0  1\n");
  const std::string usual = folder / "usual.ppm", by_one = folder / "by_one.ppm";
  EXPECT_EQ(RunProgram({scene, usual, "-width", "64", "-height", "64"}).status, 0);
  for (const char* threads : {"0", "8"}) {
    const Finished finished = RunProgram({scene, by_one, "-width", "64", "-height", "64", "-threads", threads}, alone);
    EXPECT_EQ(finished.status, 0) << finished.error;
    EXPECT_EQ(ReadFile(by_one), ReadFile(usual));
  }
}

TEST(Extremes, L11_SmallStacksAreReportedAndSoftLimitsRaised) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  const std::string words = std::string(" ") + place.Scene() + " " + (place / "out.ppm") + " -width 8 -height 8 -quiet";
  const auto with_limit = [&](const std::string& limit) {
    const std::string script = limit + "; exec " + ProgramName() + words + " 2>" + (place / "error");
    return std::system(("sh -c '" + script + "'").c_str());
  };
  EXPECT_EQ(WEXITSTATUS(with_limit("ulimit -s 64")), 1);
  EXPECT_TRUE(Has(ReadFile(place / "error"), "the stack is limited to 64 KiB, and 256 are needed"));
  EXPECT_FALSE(fs::exists(place / "out.ppm"));
  for (const char* enough : {"ulimit -S -s 64", "ulimit -s 256"}) {
    fs::remove(place / "out.ppm");
    const int status = with_limit(enough);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << enough << ReadFile(place / "error");
    EXPECT_TRUE(fs::exists(place / "out.ppm")) << enough;
  }
}

TEST(Extremes, L11_ScarceResourcesGiveTheImageOrAMessage) {
  NEEDS_THE_PROGRAM();
  const SceneFolder place;
  const std::string image = place / "out.ppm", error = place / "error";
  const auto run = [&](const std::string& surroundings) {
    fs::remove(image);
    const std::string script =
        surroundings + ProgramName() + " " + place.Scene() + " " + image + " -width 32 -height 32 -threads 100 -quiet";
    return std::system(("sh -c '" + script + "' 2>" + error).c_str());  // opened before the limit is set
  };
  ASSERT_EQ(run("exec "), 0);
  const std::string whole = ReadFile(image);
  for (const char* limit : {"ulimit -n 16; exec ", "ulimit -n 4; exec ", "ulimit -v 300000; exec ",
                            "ulimit -v 40000; exec ", "exec taskset 1 "}) {
    const int status = run(limit);
    ASSERT_TRUE(WIFEXITED(status)) << limit;
    if (WEXITSTATUS(status) == 0)
      EXPECT_TRUE(ReadFile(image) == whole) << limit;
    else
      EXPECT_TRUE(!fs::exists(image) && !ReadFile(error).empty()) << limit << WEXITSTATUS(status);
  }
}

}  // namespace
}  // namespace ray::testing
