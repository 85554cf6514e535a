// COMP30019's command line, as words, and the options of raypro that they become.
#include "source/app/options/Comp30019.h"

#include <gtest/gtest.h>


namespace ray {
namespace {

using CourseWords = std::vector<std::string>;

/// With the two required options.
RenderOptions AskedOfCourse(CourseWords words) {
  words.insert(words.end(), {"-f", "in.txt", "-o", "out.png"});
  return comp30019::ReadCommandLine(words);
}

TEST(Comp30019CommandLine, EveryOptionHasItsDefault) {
  const RenderOptions options = AskedOfCourse({});
  EXPECT_EQ(options.files.scene, "in.txt");
  EXPECT_EQ(options.files.image, "out.png");
  EXPECT_EQ(options.render.width, 400);
  EXPECT_EQ(options.render.height, 400);
  EXPECT_EQ(options.render.samples, 1);
  EXPECT_EQ(options.render.mode, RenderMode::whitted);
  EXPECT_FALSE(options.render.camera.HasLens());
  EXPECT_FALSE(options.render.view);
  EXPECT_FALSE(options.request);
}

TEST(Comp30019CommandLine, EveryOptionHasALongAndAShortName) {
  const CourseWords long_words{"--width",           "300",   "--height=200",   "--aa-mult", "3",           "--ambient",
                               "--cam-pos",         "1,2,3", "--cam-axis",     "0,1,0",     "--cam-angle", "30",
                               "--aperture-radius", "0.06",  "--focal-length", "1.5",       "--quality",   "1"};
  const CourseWords short_words{"-w",    "300", "-h", "200", "-x",   "3",  "-l",  "-p", "1,2,3", "-a",
                                "0,1,0", "-n",  "30", "-r",  "0.06", "-t", "1.5", "-q", "1"};
  for (const CourseWords& words : {long_words, short_words}) {
    const RenderOptions options = AskedOfCourse(words);
    EXPECT_EQ(options.render.width, 300);
    EXPECT_EQ(options.render.height, 200);
    EXPECT_EQ(options.render.samples, 24 * 24);
    EXPECT_EQ(options.render.mode, RenderMode::path);
    EXPECT_EQ(options.render.camera.aperture, 0.06);
    EXPECT_EQ(options.render.camera.focus, 1.5);
    ASSERT_TRUE(options.render.view);
    EXPECT_EQ(options.render.view->eye, (R3::Point{1, 2, -3}));
  }
}

TEST(Comp30019CommandLine, OneSidedIsAcceptedInRayprosSpellingToo) {
  EXPECT_FALSE(AskedOfCourse({}).parse.one_sided);
  for (const char* word : {"-one_sided", "--one_sided", "--one-sided"})
    EXPECT_TRUE(AskedOfCourse({word, "-w", "300"}).parse.one_sided) << word;
}

TEST(Comp30019CommandLine, HIsTheHeightAndNotHelp) { EXPECT_EQ(AskedOfCourse({"-h", "300"}).render.height, 300); }

TEST(Comp30019CommandLine, HelpIsAnsweredWithAnyOtherOptions) {
  for (const CourseWords& words : {CourseWords{"--help"}, CourseWords{"-x", "nonsense", "--help"}}) {
    const RenderOptions options = comp30019::ReadCommandLine(words);
    EXPECT_TRUE(options.Asks("help"));
    EXPECT_EQ(options.subject, "comp30019");
  }
  const std::string help = comp30019::Help();
  for (const char* name :
       {"-f, --file", "-o, --output", "-w, --width", "-h, --height", "-x, --aa-mult", "-l, --ambient", "-p, --cam-pos",
        "-a, --cam-axis", "-n, --cam-angle", "-r, --aperture-radius", "-t, --focal-length", "-q, --quality", "--help"})
    EXPECT_NE(help.find(name), std::string::npos) << name;
}

TEST(Comp30019CommandLine, ValuesMayBeNegative) {
  for (const CourseWords& words :
       {CourseWords{"-p", "-1,2,-.5"}, CourseWords{"--cam-pos", "-1,2,-0.5"}, CourseWords{"--cam-pos=-1,2,-.5"}}) {
    const RenderOptions options = AskedOfCourse(words);
    ASSERT_TRUE(options.render.view);
    EXPECT_EQ(options.render.view->eye, (R3::Point{-1, 2, 0.5}));
  }
  EXPECT_TRUE(AskedOfCourse({"--cam-angle", "-45"}).render.view);
}

TEST(Comp30019CommandLine, AboutXTheCameraTurnsDown) {
  const auto view = AskedOfCourse({"-p", "0,2,-0.5", "-a", "2,0,0", "-n", "90"}).render.view;
  ASSERT_TRUE(view);
  EXPECT_NEAR(Length(view->towards - R3::Vector{0, -1, 0}), 0, 1e-15);
  EXPECT_NEAR(Length(view->up - R3::Vector{0, 0, -1}), 0, 1e-15);  // the course's +z
  EXPECT_NEAR(Length(view->right - R3::Vector{1, 0, 0}), 0, 1e-15);
}

TEST(Comp30019CommandLine, AnAxisOfAnyLengthTurnsRigidly) {
  for (const char* axis : {"0,0.707,0.707", "1,2,3", "-1e-3,0,0", "0,0,1e5"}) {
    const auto view = AskedOfCourse({"--cam-axis", axis, "-n", "33"}).render.view;
    ASSERT_TRUE(view);
    EXPECT_NEAR(Dot(view->towards, view->up), 0, 1e-15) << axis;
    EXPECT_NEAR(Length(Cross(view->towards, view->up) - view->right), 0, 4e-15) << axis;
  }
}

TEST(Comp30019CommandLine, ATurnByNothingLeavesTheCameraToTheBit) {
  const auto view = AskedOfCourse({"-p", "0,0,1", "-a", "0,0,0", "-n", "0"}).render.view;
  ASSERT_TRUE(view);
  EXPECT_EQ(view->towards, (R3::Vector{0, 0, -1}));
  EXPECT_EQ(view->eye, (R3::Point{0, 0, -1}));
}

TEST(Comp30019CommandLine, EachLevelOfQualityHalvesTheNoise) {
  EXPECT_EQ(AskedOfCourse({"-q", "0"}).render.trace.shadow_samples, 16);
  EXPECT_EQ(AskedOfCourse({"-q", "3"}).render.trace.shadow_samples, 16 * 64);
  EXPECT_EQ(AskedOfCourse({"-q", "3"}).render.samples, 1);
  EXPECT_EQ(AskedOfCourse({"-l", "-q", "2"}).render.samples, 16 * 16);
  EXPECT_EQ(AskedOfCourse({"-r", ".1", "-x", "2", "-q", "1"}).render.samples, 16 * 16);
}

TEST(Comp30019CommandLine, IsChosenByProgramNameOrFirstOption) {
  const auto is_asked_for = [](std::vector<const char*> words) {
    return comp30019::IsAskedFor(static_cast<int>(words.size()), words.data());
  };
  EXPECT_TRUE(is_asked_for({"comp30019"}));
  EXPECT_TRUE(is_asked_for({"/usr/local/bin/comp30019", "-x", "3"}));
  EXPECT_TRUE(is_asked_for({"raypro", "-as", "comp30019"}));
  EXPECT_TRUE(is_asked_for({"raypro", "--as=comp30019"}));
  EXPECT_FALSE(is_asked_for({"raypro"}));
  EXPECT_FALSE(is_asked_for({"raypro", "-quiet", "-as", "comp30019"}));
  EXPECT_FALSE(is_asked_for({"raypro", "-as", "cos426"}));
  EXPECT_FALSE(is_asked_for({"raypro", "comp30019"}));
  EXPECT_FALSE(is_asked_for({}));
}

}  // namespace
}  // namespace ray
