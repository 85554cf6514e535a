// rayview from outside, as far as it goes without anything to draw with.
#include <gtest/gtest.h>

#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

const std::string small_scene = "camera 0 0 6  0 0 -1  0 1 0  0.3  0.1 100\nsphere -1  0 0 0  1\n";
const std::vector<std::string> nothing;

bool Contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

Finished Rayview(const std::vector<std::string>& words) {
  return RunProgram(words, {.program = "RAYVIEW", .environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}});
}

/// A folder with a good scene and a bad one in it.
struct Place : TemporaryFolder {
  Place() {
    WriteFile(*this / "in.scn", small_scene);
    WriteFile(*this / "bad.scn", "spere 0 0 0 1\n");
  }
  std::string Scene() const { return *this / "in.scn"; }
};

TEST(Rayview, ExitStatusSaysWhatWentWrongAndNoFileIsLeft) {
  NEEDS_RAYVIEW();
  const Place place;
  const std::string scene = place.Scene();
  const struct {
    std::vector<std::string> words;
    int status;
    const char* message;
  } cases[] = {
      {{}, 2, "rayview: no scene is named"},
      {{scene, place / "out.png"}, 2, "one name too many"},
      {{scene, "-widht", "3"}, 2, "-width"},
      {{scene, "-crop", "0", "0", "1", "1"}, 2, "-crop is an option of raypro"},
      {{scene, "-image", place / "out.xyz"}, 2, ".png"},
      {{scene, "-output_image", place / "out"}, 2, "extension"},
      {{scene, "-screenshot", place / "out.scn"}, 2, "extension"},
      {{scene, "-image", place / "a.png", "-screenshot", place / "a.png"}, 2, "-image and -screenshot are the same"},
      {{place / "bad.scn", "-image", place / "missing/out.ppm"}, 4, "does not exist"},
      {{scene, "-output_image", place / "missing/out.ppm"}, 4, "does not exist"},
      {{scene, "-screenshot", place / "missing/out.ppm"}, 4, "does not exist"},
      {{scene, "-record", place / "missing/events"}, 4, "does not exist"},
      {{scene, "-record", scene}, 4, "itself"},
      {{place / "missing.scn"}, 3, "missing.scn"},
      {{place / "bad.scn", "-headless"}, 3, "bad.scn:1:1"},
  };
  for (const auto& [words, status, message] : cases) {
    const Finished done = Rayview(words);
    EXPECT_EQ(done.status, status) << message << ": " << done.error;
    EXPECT_TRUE(Contains(done.error, message)) << done.error;
    EXPECT_EQ(done.output, "");
    EXPECT_EQ(place.Others({"in.scn", "bad.scn"}), nothing) << done.error;
  }
}

TEST(Rayview, WithoutADisplayItSaysSoInOneLine) {
  NEEDS_RAYVIEW();
  const Place place;
  const Finished done = Rayview({place.Scene()});
  EXPECT_EQ(done.status, 1);
  EXPECT_TRUE(done.error.starts_with("rayview: ")) << done.error;
  EXPECT_EQ(done.error.find('\n'), done.error.size() - 1) << done.error;
}

TEST(Rayview, RequestsPrintToStandardOutputAndNeedNoDisplay) {
  NEEDS_RAYVIEW();
  for (const std::vector<std::string>& words : {std::vector<std::string>{"-help"},
                                                {"-help", "viewer"},
                                                {"-version"},
                                                {"-list"},
                                                {"-man"},
                                                {"-complete", "fish"},
                                                {"nonsense", "-width", "abc", "-help"}}) {
    const Finished done = Rayview(words);
    EXPECT_EQ(done.status, 0) << words[0] << done.error;
    EXPECT_NE(done.output, "") << words[0];
    EXPECT_EQ(done.error, "") << words[0];
  }
}

}  // namespace
}  // namespace ray::testing
