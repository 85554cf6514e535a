// Whoever edits a scene in a window gets the file back that was written by hand, but for the words that changed.

#include "source/view/edit/ScnEdits.h"

#include <gtest/gtest.h>

#include "source/scene/CameraText.h"
#include "tests/source/view/edit/EditedScene.h"

namespace ray {
namespace {

const std::string material_line = "material .1 .1 .1  0.80 .2 .1  0 0 0  0 0 0  0 0 0  10 1 0  # 0 red\r\n";

TEST(ScnEdits, ChangeTheWordsOfAColorAndNothingElse) {
  EditedScene edited("# a ball\r\n" + material_line + "sphere 0  0 0 0  1\r\n");
  const auto material = edited.Statement("material");
  const std::string after =
      edited.After(WithValues(edited.Places(), material, edited.Field(material, "diffuse (kd)"), {0.8, 0.6, 0.1}));
  EXPECT_EQ(after, "# a ball\r\nmaterial .1 .1 .1  0.80 0.6 .1  0 0 0  0 0 0  0 0 0  10 1 0  # 0 red\r\n"
                   "sphere 0  0 0 0  1\r\n");
  EXPECT_EQ(edited.scene().materials.back().kd, (R2::Color{0.8, 0.6, 0.1}));
}

TEST(ScnEdits, WriteNumbersThatReadBackAsTheSame) {
  EditedScene edited("sphere -1  0 0 0  1\n");
  const double third = 1.0 / 3;
  const auto sphere = edited.Statement("sphere");
  edited.After(WithValues(edited.Places(), sphere, edited.Field(sphere, "radius"), {third}));
  EXPECT_EQ(edited.Field(edited.Statement("sphere"), "radius").values[0], third);
}

TEST(ScnEdits, TakenBackLeaveEveryByte) {
  const std::string text = "\xEF\xBB\xBF" + material_line + "sphere 0 0 0 0 1 sphere 0 3 0 0 1 # two\nmesh 0 x.off";
  EditedScene edited("sphere -1 0 0 0 1\n");
  edited.Write("x.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  edited.Write("scene.scn", text);
  edited.Read();
  for (const TextEdits& edits :
       {Moved(edited.Places(), edited.Statement("mesh"), {1, 2, 3}),
        Moved(edited.Places(), edited.Statement("sphere", 1), {1, 2, 3}),
        Removed(edited.Places(), edited.Statement("sphere")), Removed(edited.Places(), edited.Statement("mesh")),
        Duplicated(edited.Places(), edited.Statement("sphere"), {1, 0, 0}).edits,
        Duplicated(edited.Places(), edited.Statement("mesh"), {1, 0, 0}).edits,
        WithCamera(edited.Places(), Camera{}), WithSettings(edited.Places(), {{"focus", "2"}, {"aperture", "1"}})}) {
    const EditedFiles files{{edited.File(), text}};
    const EditedFiles changed = Edited(files, edits);
    EXPECT_NE(changed, files);
    EXPECT_EQ(Edited(changed, Reversed(edits)), files);
  }
}

/// A shape, or a light, and the words of it once it is moved by (1, 2, 3).
struct MovedThing {
  std::string before, after;
};

TEST(ScnEdits, MoveEachKindOfShapeAndLightAsAWhole) {
  const MovedThing things[] = {
      {"sphere -1 0 0 0 1", "sphere -1 1 2 3 1"},
      {"box -1 0 0 0 1 1 1", "box -1 1 2 3 2 3 4"},
      {"tri -1 0 0 0 1 0 0 0 1 0", "tri -1 1 2 3 2 2 3 1 3 3"},
      {"disc -1 0 0 0 0 1 0 .5", "disc -1 1 2 3 0 1 0 .5"},
      {"line -1 0 0 0 1 1 1", "line -1 1 2 3 2 3 4"},
      {"point_light 1 1 1 0.1 0.2 0.3 1 0 0", "point_light 1 1 1 1.1 2.2 3.3 1 0 0"},
      {"begin -1 1 0 0 5 0 1 0 6 0 0 1 7 0 0 0 1 sphere -1 0 0 0 1 end",
       "begin -1 1 0 0 6 0 1 0 8 0 0 1 10 0 0 0 1 sphere -1 0 0 0 1 end"},
      {"begin -1 translate 1 1 1 scale 2 sphere -1 0 0 0 1 end",
       "begin -1 translate 2 3 4 scale 2 sphere -1 0 0 0 1 end"},
      {"begin -1 scale 2 sphere -1 0 0 0 1 end", "begin -1 translate 1 2 3 scale 2 sphere -1 0 0 0 1 end"},
      {"quad -1 0 0 0 1 0 0 1 1 0 0 1 0", "begin -1 translate 1 2 3  quad -1 0 0 0 1 0 0 1 1 0 0 1 0  end"},
  };
  for (const auto& [before, after] : things) {
    EditedScene edited(before + "  # it\n");
    EXPECT_EQ(edited.After(Moved(edited.Places(), 0, {1, 2, 3})), after + "  # it\n");
  }
}

TEST(ScnEdits, TakeOutWholeLinesOrTheStatementAlone) {
  EditedScene lines("# top\n  sphere -1 0 0 0\n 1 # a ball\nsphere -1 3 0 0 1\n");
  EXPECT_EQ(lines.After(Removed(lines.Places(), 0)), "# top\nsphere -1 3 0 0 1\n");
  EditedScene one_line("sphere -1 0 0 0 1  sphere -1 3 0 0 1 # two\n");
  EXPECT_EQ(one_line.After(Removed(one_line.Places(), 0)), "sphere -1 3 0 0 1 # two\n");
  EditedScene last("sphere -1 0 0 0 1  sphere -1 3 0 0 1 # two\n");
  EXPECT_EQ(last.After(Removed(last.Places(), 1)), "sphere -1 0 0 0 1 # two\n");
  EditedScene group("begin -1 scale 2\n begin -1 scale 3\n end\n end # both\nsphere -1 3 0 0 1");
  EXPECT_EQ(group.After(Removed(group.Places(), 0)), "sphere -1 3 0 0 1");
}

TEST(ScnEdits, DuplicateLinesWithTheirComments) {
  EditedScene edited("sphere -1 0 0 0 1  # a ball");
  const Copied copied = Duplicated(edited.Places(), 0, {2, 0, 0});
  const std::string after = edited.After(copied.edits);
  EXPECT_EQ(after, "sphere -1 0 0 0 1  # a ball\nsphere -1 2 0 0 1  # a ball");
  EXPECT_EQ(StatementAt(edited.Places(), 0, copied.begin), 1u);
}

TEST(ScnEdits, RefuseWhatAVariableSays) {
  EditedScene edited("define r 2\nsphere -1 0 0 0 $r\nsphere -1 $r 0 0 1\n");
  const auto sphere = edited.Statement("sphere");
  EXPECT_THROW(WithValues(edited.Places(), sphere, edited.Field(sphere, "radius"), {1}), EditRefusal);
  EXPECT_THROW(Moved(edited.Places(), edited.Statement("sphere", 1), {1, 0, 0}), EditRefusal);
  EXPECT_THROW(Removed(edited.Places(), edited.Statement("define")), EditRefusal);
}

TEST(ScnEdits, EditTheIncludedFileThatHoldsTheLine) {
  EditedScene edited("sphere -1 0 0 0 1\n");
  edited.Write("part.scn", "\n" + material_line + "sphere 0 5 0 0 1\n");
  edited.Write("scene.scn", "include part.scn\nmaterial 0 0 0 1 1 1 0 0 0 0 0 0 0 0 0 1 1 0\ninclude part.scn\n");
  edited.Read();
  const ScnPlaces& places = edited.Places();
  ASSERT_EQ(places.materials.size(), 4u) << "the default one, that of the part, that of the scene, that of the part";
  EXPECT_EQ(places.materials[0], ScnPlaces::nowhere);
  EXPECT_EQ(places.statements[places.materials[1]].file, 1u);
  EXPECT_EQ(places.statements[places.materials[2]].file, 0u);
  EXPECT_EQ(CommentOf(places, places.materials[1]), "0 red");
  EXPECT_TRUE(CommentOf(places, places.materials[2]).empty());
  const std::string after = edited.After(Moved(places, edited.Statement("sphere"), {1, 0, 0}), "part.scn");
  EXPECT_EQ(after, "\n" + material_line + "sphere 0 6 0 0 1\n");
}

TEST(ScnEdits, MakeTheCameraTheSameToTheBit) {
  for (const char* line : {"camera 0 0 5  0 0 -1  0 1 0  .3 .01 100  # mine\n", "# no camera\n", "sphere -1 0 0 0 1",
                           "camera look_at 0 0 5  0 0 0  0 1 0  40 # mine\n"}) {
    EditedScene edited(line);
    Camera camera = Aim({1.25, 2, 3}, {-0.3, -0.2, -1}, {0.1, 1, 0}).camera;
    camera.xfov = 0.31;
    camera.near = edited.scene().camera.near, camera.far = edited.scene().camera.far;
    edited.After(WithCamera(edited.Places(), camera));
    EXPECT_EQ(CameraLine(edited.scene().camera), CameraLine(camera)) << line;
  }
}

TEST(ScnEdits, KeepLookAtWhereItSaysAsMuch) {
  EditedScene edited("camera look_at 0 0 5  0 0 0  0 1 0  40 # mine\n");
  Camera camera = edited.scene().camera;
  camera.eye = {0, 0, 7};
  EXPECT_EQ(edited.After(WithCamera(edited.Places(), camera)), "camera look_at 0 0 7  0 0 2  0 1 0  40 # mine\n");
}

TEST(ScnEdits, ChangeASettingWhereItIsElseAddIt) {
  EditedScene edited("camera 0 0 5  0 0 -1  0 1 0  .3 .01 100  # mine\r\nset samples 4 # few\r\n");
  EXPECT_EQ(edited.After(WithSettings(edited.Places(), {{"samples", "9"}, {"focus", "5"}})),
            "camera 0 0 5  0 0 -1  0 1 0  .3 .01 100  # mine\r\nset focus 5\r\nset samples 9 # few\r\n");
}

TEST(ScnEdits, FindStatementsByLocationBehindLettersOfSeveralBytes) {
  EditedScene edited("\xEF\xBB\xBF# \xC3\xA4\r# \xC3\xB6\r\nsphere -1 0 0 0 1 sphere -1 3 0 0 1\n");
  for (std::uint32_t i = 0; i < 2; ++i) {
    const Location& location = edited.scene().root.children[i].location;
    EXPECT_EQ(StatementAt(edited.Places(), location), i);
    const Location back = LocationAt(edited.Places(), 0, edited.Places().statements[i].begin);
    EXPECT_EQ(back.line, location.line);
    EXPECT_EQ(back.column, location.column);
  }
}

}  // namespace
}  // namespace ray
