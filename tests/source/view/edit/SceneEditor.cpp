// Changes of a scene in the viewer: seen at once, undone and redone, and saved into the lines they are of.

#include "source/view/commands/Commands.h"
#include "source/view/edit/SceneEditor.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "source/scene/CameraText.h"
#include "tests/source/view/ScriptedViewer.h"
#include "tests/source/view/WithOptions.h"

namespace ray {
namespace {

namespace fs = std::filesystem;

using project::BytesOf;

std::vector<std::string> LinesOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

class EditorTest : public ScriptedViewer<WithOptions, 64, 48> {
 protected:
  const Camera& camera() const { return viewer_->navigator().camera(); }
  R2::Image Rendered() const {
    const LoadedScene& scene = viewer_->scene();
    return Render(scene.world, *scene.accelerator, viewer_->state().SettingsOfView()).image;
  }
  void SetUp() override {
    before_ = BytesOf(file_);
    Open(file_);
  }
  SceneEditor& Editor() { return viewer_->state().editor; }
  const ScnPlaces& Places() const { return viewer_->scene().places; }
  /// The node that a command of the file makes, the first of them.
  void Choose(const std::string& command) {
    const auto& nodes = viewer_->scene().world.Nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto statement = StatementAt(Places(), nodes[i].node->location);
      if (statement && CommandOf(Places(), *statement) == command) return ChooseNode(viewer_->state(), i);
    }
    FAIL() << "there is no " << command;
  }
  std::string Chosen() {
    const auto statement = Editor().ChosenStatement();
    return statement ? NameOf(Places(), *statement) : "none";
  }
  void Set(std::uint32_t statement, const std::string& name, const std::vector<double>& values,
           bool continues = false) {
    for (const ScnField& field : FieldsOf(Places(), statement))
      if (field.name == name) {
        Editor().SetField(statement, field, values, continues);
        return Editor().DoHeld();  // where the machine is slow, what continues waits for the button
      }
    FAIL() << "there is no field " << name;
  }
  std::uint32_t MaterialOfChosen() { return Places().materials[*Editor().ChosenMaterial()]; }
  void MakeItGreen() { Set(MaterialOfChosen(), "diffuse (kd)", {0.1, 0.6, 0.15}); }
  std::string Message() const { return viewer_->Message(); }
  bool Says(const std::string& words) const { return Message().find(words) != std::string::npos; }
  std::vector<std::size_t> ChangedLines() const {
    const auto was = LinesOf(before_), is = LinesOf(BytesOf(file_));
    EXPECT_EQ(was.size(), is.size());
    std::vector<std::size_t> changed;
    for (std::size_t i = 0; i < std::min(was.size(), is.size()); ++i)
      if (was[i] != is[i]) changed.push_back(i + 1);
    return changed;
  }

  CopiedScenes scenes_;
  const fs::path file_ = scenes_ / "hello.scn";
  std::string before_;
};

TEST_F(EditorTest, SavesAColorIntoOneLine) {
  Choose("cone");
  MakeItGreen();
  EXPECT_TRUE(ChangedLines().empty()) << "not before it is saved";
  EXPECT_TRUE(Editor().HasUnsaved());
  Do("key Control+S");
  EXPECT_FALSE(Editor().HasUnsaved());
  ASSERT_EQ(ChangedLines().size(), 1u);
  EXPECT_EQ(LinesOf(BytesOf(file_))[ChangedLines()[0] - 1],
            "material  1 .3 .1  0.1 0.6 0.15   0.35 0.35 0.35   0 0 0  0 0 0   40 1 0                        # 3 red");
}

TEST_F(EditorTest, UndoesAndRedoesASessionAndSavesItsLines) {
  Choose("cone");
  MakeItGreen();
  Do("key =\nkey =");
  EXPECT_EQ(Editor().Describe(), "3 changes, not saved");
  const std::string moved = CameraLine(camera());
  Do("key Control+Z\nkey Control+Z\nkey Control+Z");
  EXPECT_EQ(viewer_->scene().places.files[0].text->bytes, before_);
  EXPECT_FALSE(Editor().HasUnsaved());
  EXPECT_EQ(Chosen(), "cone, line 18");
  Do("key Control+Y\nkey Control+Shift+Z\nkey Control+Y\nkey Control+Y");
  EXPECT_TRUE(Says("nothing to redo"));
  EXPECT_EQ(CameraLine(camera()), moved) << "the view stays";
  Do("key Control+S");
  EXPECT_EQ(ChangedLines(), (std::vector<std::size_t>{11, 18}));
  Do("key Control+Z\nkey Control+Z\nkey Control+Z\nkey Control+S");
  EXPECT_EQ(BytesOf(file_), before_);
}

TEST_F(EditorTest, ShowsAnEditAsTheSavedFileIsShown) {
  Choose("sphere");
  Do("key A\nkey =\nkey Shift+-");
  const R2::Image edited = Rendered();
  Do("key Control+S");
  Open(file_);
  EXPECT_EQ(Rendered(), edited);
}

TEST_F(EditorTest, MakesOneStepOfWhatASliderDoes) {
  Choose("cone");
  Set(MaterialOfChosen(), "shininess (n)", {41}, false);
  Set(MaterialOfChosen(), "shininess (n)", {45}, true);
  Set(MaterialOfChosen(), "shininess (n)", {50}, true);
  Set(MaterialOfChosen(), "shininess (n)", {60}, false);
  Do("key Control+Z");
  EXPECT_EQ(viewer_->scene().parsed.scene.materials[4].n, 50);
  Do("key Control+Z");
  EXPECT_EQ(viewer_->scene().parsed.scene.materials[4].n, 40);
}

TEST_F(EditorTest, RefusesWhatNoSceneCanHave) {
  Choose("cone");
  Set(*Editor().ChosenStatement(), "radius", {-1});
  EXPECT_TRUE(Says("radius must not be negative")) << Message();
  EXPECT_EQ(viewer_->scene().places.files[0].text->bytes, before_);
  EXPECT_EQ(Editor().Describe(), "none");
}

TEST_F(EditorTest, MovesAMeshByTheGroupAroundIt) {
  Choose("mesh");
  const R3::Box before = viewer_->scene().parsed.scene.root.children.back().bounds;
  Do("key =");
  EXPECT_EQ(LinesOf(viewer_->scene().places.files[0].text->bytes)[20],
            "  0.75 0 0.3 0.75   0 0.8 0 0.66   -0.3 0 0.75 -1.7   0 0 0 1");
  const R3::Box after = viewer_->scene().parsed.scene.root.children.back().bounds;
  EXPECT_NEAR(after.low.x - before.low.x, Editor().Step(), 1e-12);
  EXPECT_EQ(Chosen(), "mesh, line 22");
}

TEST_F(EditorTest, MovesAlongTheWorldInsideOfTurnedGroups) {
  std::ofstream(file_) << "begin -1 rotate 90 0 0 1 scale 2\nsphere -1 1 1 0 .5\nbox -1 0 0 0 1 1 1\nend\n";
  Open(file_);
  Choose("sphere");
  const R3::Point before = viewer_->scene().world.Instances()[0].bounds.Center();
  Do("key =");
  const R3::Point after = viewer_->scene().world.Instances()[0].bounds.Center();
  EXPECT_NEAR(after.x - before.x, Editor().Step(), 1e-11);
  EXPECT_NEAR(after.y, before.y, 1e-11);
}

TEST_F(EditorTest, DuplicatesAndDeletesWhatIsChosen) {
  Choose("cone");
  const auto shapes = [&] { return viewer_->scene().world.Instances().size(); };
  const std::size_t before = shapes();
  Do("key Control+D");
  EXPECT_EQ(shapes(), before + 1);
  EXPECT_EQ(Chosen(), "cone, line 19") << "the copy";
  Do("key Delete");
  EXPECT_EQ(shapes(), before);
  EXPECT_EQ(viewer_->scene().places.files[0].text->bytes, before_);
  EXPECT_EQ(Chosen(), "none");
  Do("key Delete");
  EXPECT_TRUE(Says("nothing is chosen"));
  Do("key Control+Z");
  EXPECT_EQ(Chosen(), "cone, line 19");
}

TEST_F(EditorTest, EditsALightLikeAnObject) {
  Editor().ChooseLight(1);
  EXPECT_EQ(Chosen(), "point_light, line 6");
  Set(*Editor().ChosenStatement(), "color", {0.5, 0.25, 0.3});
  Do("key A\nkey =\nkey Control+S");
  EXPECT_EQ(ChangedLines(), std::vector<std::size_t>{6});
  EXPECT_EQ(Chosen(), "point_light, line 6");
  Do("key Control+D");
  EXPECT_EQ(viewer_->scene().parsed.scene.lights.size(), 3u);
  EXPECT_EQ(Chosen(), "point_light, line 7");
}

TEST_F(EditorTest, DragsTheChosenAlongTheAxisUnderThePointer) {
  Do("resize 400 300");
  Choose("cone");
  const auto center = [&] { return viewer_->scene().world.Instances()[3].bounds.Center(); };
  const R3::Point before = center();
  const auto pixel = *PixelOf(camera(), before, {400, 300});
  const auto at = [](double x, double y) { return std::to_string(x) + " " + std::to_string(y); };
  Do("drag left " + at(pixel.x, pixel.y) + " " + at(pixel.x - 40, pixel.y) + " Control Shift");
  const R3::Point after = center();
  EXPECT_EQ(after.y, before.y);
  EXPECT_EQ(after.z, before.z);
  EXPECT_LT(after.x, before.x);
  EXPECT_NEAR(PixelOf(camera(), after, {400, 300})->x, pixel.x - 40, 2);
  EXPECT_EQ(Editor().Describe(), "1 change, not saved") << "of all moves of the drag";
}

TEST_F(EditorTest, WritesTheViewAsTheScenesCamera) {
  Do("key Shift+K");
  EXPECT_TRUE(Says("already"));
  Do("drag left 10 10 30 20\nkey Shift+K");
  EXPECT_FALSE(viewer_->state().HasMovedCamera());
  Do("key Control+S");
  EXPECT_EQ(ChangedLines(), std::vector<std::size_t>{2});
  Do("key Control+Z");
  EXPECT_FALSE(viewer_->state().HasMovedCamera()) << "who looks through the scene's camera goes with it";
}

TEST_F(EditorTest, AsksOnceBeforeChangesAreLost) {
  Choose("cone");
  MakeItGreen();
  Do("close");
  EXPECT_FALSE(viewer_->IsClosed());
  EXPECT_TRUE(Says("unsaved changes"));
  Do("close");
  EXPECT_TRUE(viewer_->IsClosed());
}

TEST_F(EditorTest, AsksOnceBeforeAnotherSceneIsOpened) {
  Choose("cone");
  MakeItGreen();
  const std::string other = "drop " + (scenes_ / "glass.scn").string();
  Do(other);
  EXPECT_EQ(viewer_->state().settings.scene, file_);
  Do(other);
  EXPECT_EQ(viewer_->state().settings.scene, scenes_ / "glass.scn");
  EXPECT_EQ(Editor().Describe(), "none");
  EXPECT_EQ(BytesOf(file_), before_);
}

TEST_F(EditorTest, NeverWritesOverWhatAnotherProgramWrote) {
  Choose("cone");
  MakeItGreen();
  const std::string other = before_ + "# by hand\n";
  std::ofstream(file_) << other;
  Do("tick 1\nkey Control+S");
  EXPECT_TRUE(Says("changed on the disk")) << Message();
  EXPECT_EQ(BytesOf(file_), other);
  Do("key Control+Shift+S");
  EXPECT_NE(BytesOf(scenes_ / "hello-2.scn").find("0.1 0.6 0.15"), std::string::npos);
  Do("key Control+R");
  EXPECT_EQ(viewer_->scene().places.files[0].text->bytes, other) << "a copy has the changes: nothing is lost";
}

TEST_F(EditorTest, SavesCopiesUnderFreeNames) {
  Choose("cone");
  MakeItGreen();
  Do("key Control+Shift+S\nkey Control+Shift+S");
  EXPECT_EQ(BytesOf(scenes_ / "hello-2.scn"), BytesOf(scenes_ / "hello-3.scn"));
  EXPECT_EQ(BytesOf(file_), before_);
  Do("close");
  EXPECT_TRUE(viewer_->IsClosed()) << "nothing would be lost";
}

TEST_F(EditorTest, EditsNoSceneOfAnotherLanguage) {
  Open(project::Root() / "scenes/solids.yaml");
  ChooseNode(viewer_->state(), 1);
  Do("key =");
  EXPECT_TRUE(Says("-convert")) << Message();
}

TEST_F(EditorTest, RefusesIncludedFilesThatCannotBeWritten) {
  if (geteuid() == 0) GTEST_SKIP() << "root writes everything";
  std::ofstream(scenes_ / "part.scn") << "sphere -1 0 0 0 1\n";
  std::ofstream(file_) << "include part.scn\n";
  fs::permissions(scenes_ / "part.scn", fs::perms::owner_read);
  Open(file_);
  Choose("sphere");
  Do("key =");
  EXPECT_TRUE(Says("cannot be written")) << Message();
}

// A yes to one question was once taken for a yes to any.
TEST_F(EditorTest, AQuestionBelongsToOneActionAndEndsWithAnother) {
  Choose("cone");
  Do("key =\nkey Control+R");
  EXPECT_TRUE(Says("unsaved changes")) << Message();
  Do("key PageDown");
  EXPECT_TRUE(Says("unsaved changes")) << Message();
  Do("key E\nkey PageDown");
  EXPECT_TRUE(Says("unsaved changes")) << "another key came between: " << Message();
  Do("tick 10\nkey PageDown");
  EXPECT_TRUE(Says("unsaved changes")) << "it was no longer to be read: " << Message();
  EXPECT_EQ(viewer_->state().settings.scene, scenes_ / "hello.scn");
  Do("key PageDown");
  EXPECT_NE(viewer_->state().settings.scene, scenes_ / "hello.scn") << "asked twice, one after the other";
}

TEST_F(EditorTest, AnIncludedFileThatChangedOnDiskIsReplacedAfterAsking) {
  std::ofstream(scenes_ / "part.scn") << "sphere -1 0 0 0 1\n";
  std::ofstream(file_) << "include part.scn\n";
  Open(file_);
  Choose("sphere");
  Do("key =");
  std::ofstream(scenes_ / "part.scn", std::ios::app) << "# touched\n";
  Do("tick 1\nkey Control+S");
  EXPECT_TRUE(Says("changed on the disk")) << Message();
  EXPECT_NE(BytesOf(scenes_ / "part.scn").find("touched"), std::string::npos);
  Do("key Control+S");
  EXPECT_TRUE(Says("saved ")) << Message();
  EXPECT_EQ(BytesOf(scenes_ / "part.scn").find("touched"), std::string::npos);
}

TEST_F(EditorTest, PageKeysGoThroughTheFolder) {
  Do("key PageDown");
  EXPECT_EQ(viewer_->state().settings.scene, scenes_ / "empty.scn") << "around the end";
  Do("key PageUp\nkey PageUp");
  EXPECT_EQ(viewer_->state().settings.scene, scenes_ / "glass.scn");
}

TEST_F(EditorTest, KeepsChangesWhenAnOptionIsChanged) {
  Choose("cone");
  MakeItGreen();
  const std::string edited = viewer_->scene().places.files[0].text->bytes;
  ChangeOption(viewer_->state(), "accel", "grid");
  EXPECT_EQ(viewer_->scene().places.files[0].text->bytes, edited);
}

}  // namespace
}  // namespace ray
