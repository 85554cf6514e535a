// The program with COMP30019's command line: the calls of its graders on scenes of the same kinds, and its exit
// statuses.
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

using CourseCall = std::vector<std::string>;

std::string CourseScene(const std::string& name) {
  return (project::Root() / "scenes/comp30019" / (name + ".txt")).string();
}

Finished RunCourse(CourseCall words) {
  words.insert(words.begin(), {"-as", "comp30019"});
  return RunProgram(words);
}

TEST(Comp30019Program, TheGradersCallsMakeTheirImages) {
  NEEDS_THE_PROGRAM();
  const CourseCall small{"-w", "48", "-h", "36"};
  const struct {
    const char* scene;
    CourseCall words;
    std::string warning = {};
  } calls[] = {
      {"corners", {}},
      {"room", {"-x", "4"}},
      {"depth", {}},
      {"two_lights", {}},
      {"mirrors", {}, "of the light ended at -max_depth 10"},
      {"glass", {}},
      {"room", {"-x", "3"}},
      {"lamps", {}},
      {"lamps", {"-q", "1"}},
      {"lamps", {"--quality", "2"}},
      {"bleeding", {"-l"}},
      {"model", {}},
      {"glossy", {}},
      {"room", {"--cam-pos", "0,2,-0.5", "--cam-axis", "1,0,0", "--cam-angle", "45"}, "the image is black"},
      {"room", {"--cam-pos", "0,0,-1", "--cam-axis", "0,0.707,0.707", "--cam-angle", "20"}},
      {"room", {"--cam-axis", "1,0,0", "--cam-angle", "-45"}},
      {"tinted_glass", {}},
      {"tinted_pyramid", {}},
      {"room", {"--aperture-radius", "0.06", "--focal-length", "1.5"}},
  };
  const TemporaryFolder folder;
  for (const auto& [scene, words, warning] : calls) {
    CourseCall all{"-f", CourseScene(scene), "--output=" + (folder / "out.png")};
    all.insert(all.end(), small.begin(), small.end());
    all.insert(all.end(), words.begin(), words.end());
    const Finished done = RunCourse(all);
    EXPECT_EQ(done.status, 0) << scene << done.error;
    EXPECT_EQ(Has(done.error, "warning"), !warning.empty()) << scene << done.error;  // progress may be shown there
    EXPECT_TRUE(Has(done.error, warning)) << scene << done.error;
    EXPECT_EQ(Decode(folder / "out.png").image.Height(), 36) << scene;
    std::filesystem::remove(folder / "out.png");
  }
}

/// Returns the mean over each eighth of an image's width and height.
std::vector<double> Eighths(const R2::Image& image) {
  std::vector<double> means(64);
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x)
      means[static_cast<std::size_t>(8 * (8 * y / image.Height()) + 8 * x / image.Width())] +=
          64 * Luminance(image.At(x, y)) / image.Width() / image.Height();
  return means;
}

// Regression: emission was a radiance with -l, and surfaces that were bright without it were nearly black.
TEST(Comp30019Program, AmbientLightAddsToThatOfLamps) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder folder;
  const auto shown = [&](const CourseCall& more) {
    CourseCall words{"-f", CourseScene("lamps"), "-o", folder / "out.png", "-w", "64", "-h", "64"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(RunCourse(words).status, 0);
    return Eighths(Decode(folder / "out.png").image);
  };
  const std::vector<double> direct = shown({}), all = shown({"-l"});
  double sum = 0, direct_sum = 0;
  for (std::size_t i = 0; i < direct.size(); ++i) {
    EXPECT_GT(all[i], direct[i] - 0.02) << "darker in eighth " << i;  // noise
    sum += all[i], direct_sum += direct[i];
  }
  EXPECT_GT(sum, 1.5 * direct_sum) << "walls of albedo .75 around all sides reflect most of the light";
}

TEST(Comp30019Program, TheSizeIs400x400ByDefault) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder folder;
  RunCourse({"-f", CourseScene("corners"), "-o", folder / "plain.png"});
  RunCourse({"-f", CourseScene("corners"), "-o", folder / "low.png", "-w", "400", "-h", "300"});
  EXPECT_EQ(Decode(folder / "plain.png").image.Width(), 400);
  EXPECT_EQ(Decode(folder / "plain.png").image.Height(), 400);
  EXPECT_EQ(Decode(folder / "low.png").image.Height(), 300);
}

TEST(Comp30019Program, ItExitsWith0OnSuccessAndOtherwiseWith1) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder folder;
  const std::string out = folder / "out.png";
  const std::string bad = WriteFile(folder / "bad.txt", "Material \"Red\" Diffuse (1, .5, .5) 1\n\nSpere\n");
  const struct {
    CourseCall words;
    int status;
    const char* message;
  } cases[] = {
      {{"--help"}, 0, ""},
      {{}, 1, "missing: -f, --file and -o, --output"},
      {{"-f", folder / "none.txt", "-o", out}, 1, "none.txt: error: no such file"},
      {{"-f", bad, "-o", out}, 1, "bad.txt:3:1: error: unknown command 'Spere'"},
      {{"-f", CourseScene("corners"), "-o", out, "-p", "0,1"}, 1, "got '0,1'"},
      {{"-f", CourseScene("corners"), "-o", folder / "no/folder/out.png"}, 1, "out.png"},
      {{"-f", CourseScene("corners"), "-o", folder / "out.webp"}, 1, "cannot write '.webp'"},
  };
  for (const auto& [words, status, message] : cases) {
    const Finished done = RunCourse(words);
    EXPECT_EQ(done.status, status) << message;
    EXPECT_NE(done.error.find(message), std::string::npos) << done.error;
    EXPECT_FALSE(std::filesystem::exists(out));
  }
}

TEST(Comp30019Program, ALinkOfThatNameNeedsNoOption) {
  NEEDS_THE_PROGRAM();
  const TemporaryFolder folder;
  const std::string link = folder / "comp30019";
  std::filesystem::create_symlink(std::filesystem::absolute(ProgramName()), link);
  setenv("COMP30019_LINK", link.c_str(), 1);
  const Finished done = RunProgram({"-f", CourseScene("corners"), "-o", folder / "out.png", "-w", "8", "-h", "6"},
                                   {.program = "COMP30019_LINK"});
  unsetenv("COMP30019_LINK");
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(Decode(folder / "out.png").image.Height(), 6);
  const Finished info = RunProgram({"-info", folder / "out.png"});
  EXPECT_NE(info.output.find("command: raypro -as comp30019 -f "), std::string::npos) << info.output;
}

TEST(Comp30019Program, TheRequestIsAnErrorUnlessItComesFirst) {
  NEEDS_THE_PROGRAM();
  const Finished done = RunProgram({"in.txt", "out.png", "-as", "comp30019"});
  EXPECT_EQ(done.status, 2);
  EXPECT_EQ(done.error, "raypro: -as comp30019 must come first\n");
}

}  // namespace
}  // namespace ray::testing
