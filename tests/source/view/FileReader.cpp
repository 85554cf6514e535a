// A window that answers while a scene is read.

#include <gtest/gtest.h>

#include <future>
#include <string>

#include "source/view/commands/Commands.h"
#include "tests/Folder.h"
#include "tests/source/view/ScriptedViewer.h"

namespace ray {
namespace {

TEST(LatestJob, ReplacesTheOneBefore) {
  std::promise<void> go;
  const std::shared_future<void> gone = go.get_future().share();
  LatestJob<int> job;
  EXPECT_FALSE(job.IsBusy());
  job.Begin([gone] { return gone.wait(), 1; });
  EXPECT_TRUE(job.IsBusy());
  EXPECT_FALSE(job.Take());
  job.Begin([gone] { return gone.wait(), 2; });
  go.set_value();
  EXPECT_EQ(job.Take(true), 2);
  EXPECT_FALSE(job.IsBusy());
  EXPECT_FALSE(job.Take(true)) << "a result is given once";
  job.Begin([]() -> int { throw std::runtime_error("no"); });
  EXPECT_THROW(job.Take(true), std::runtime_error);
  EXPECT_FALSE(job.IsBusy());
}

/// Scenes with a mesh that takes far longer to read than the moment that Begin waits.
class SlowScenes : public ViewerTest {
 protected:
  void SetUp() override {
    constexpr int side = 300;  // squares, of two triangles
    std::string mesh =
        "OFF\n" + std::to_string((side + 1) * (side + 1)) + " " + std::to_string(2 * side * side) + " 0\n";
    for (int y = 0; y <= side; ++y)
      for (int x = 0; x <= side; ++x) mesh += std::to_string(x) + " " + std::to_string(y) + " 0\n";
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const int a = y * (side + 1) + x, b = a + side + 1;
        mesh += "3 " + std::to_string(a) + " " + std::to_string(a + 1) + " " + std::to_string(b) + "\n";
        mesh += "3 " + std::to_string(b) + " " + std::to_string(a + 1) + " " + std::to_string(b + 1) + "\n";
      }
    folder_.Write("grid.off", mesh);
    folder_.Write("small.scn", "sphere -1  0 0 0  1\n");
    folder_.Write("slow.scn", "mesh -1 grid.off\nsphere -1  0 0 0  1\n");
    folder_.Write("wrong.scn", "mesh -1 grid.off\nspere -1  0 0 0  1\n");
    Open(folder_ / "small.scn");
    viewer_->Handle(ResizeEvent{640, 480, 1});
  }
  /// Handles events as they come, as a window does; a script waits for each scene.
  void Happen(const std::string& script) {
    for (const ScriptStep& step : ReadEventScript({"test", script}))
      if (const auto* event = std::get_if<Event>(&step.what)) viewer_->Handle(*event), viewer_->Update();
  }
  void Drop(const char* name) { Happen("drop " + (folder_ / name).string()); }
  bool IsSeen(const std::string& words) const {
    std::string all;
    for (const Label& label : viewer_->Show().labels) all += label.text + " ";
    return all.find(words) != std::string::npos;
  }
  std::size_t Shapes() const { return viewer_->scene().world.Instances().size(); }
  bool SceneIs(const char* name) const { return viewer_->state().settings.scene == (folder_ / name).string(); }

  project::Folder folder_;
};

TEST_F(SlowScenes, LeaveTheWindowToItsUserWhileTheyAreRead) {
  Drop("slow.scn");
  ASSERT_TRUE(viewer_->IsReading());
  EXPECT_TRUE(IsSeen("reading slow.scn"));
  EXPECT_TRUE(SceneIs("small.scn"));
  const Camera before = camera();
  Happen("drag left 10 10 30 30");
  EXPECT_FALSE(IsCameraOf(before));
  viewer_->WaitForScene();
  EXPECT_TRUE(SceneIs("slow.scn"));
  EXPECT_EQ(Shapes(), 2u);
  EXPECT_FALSE(IsSeen("reading"));
}

TEST_F(SlowScenes, AreNotReplacedByAReference) {
  folder_.Write("student.rays", "camera 0 0 5  0 0 1\n");
  Drop("slow.scn");
  Drop("student.rays");
  EXPECT_EQ(viewer_->Message().substr(0, 22), "wait: reading slow.scn");
  viewer_->WaitForScene();
  EXPECT_TRUE(SceneIs("slow.scn"));
  Drop("student.rays");
  viewer_->WaitForScene();
  EXPECT_TRUE(SceneIs("slow.scn"));
  EXPECT_FALSE(viewer_->Rays().Foreign().empty());
}

TEST_F(SlowScenes, StopWithEscape) {
  Drop("slow.scn");
  Happen("key Escape");
  EXPECT_FALSE(viewer_->IsReading());
  EXPECT_EQ(viewer_->Message().substr(0, 24), "stopped reading slow.scn");
  viewer_->WaitForScene();
  EXPECT_TRUE(SceneIs("small.scn"));
}

TEST_F(SlowScenes, AreReplacedByTheNextOne) {
  Drop("slow.scn");
  Drop("small.scn");
  viewer_->WaitForScene();
  EXPECT_TRUE(SceneIs("small.scn"));
  Happen("key Escape");
  Drop("wrong.scn");
  EXPECT_EQ(StateLine("problem"), "");
  viewer_->WaitForScene();
  EXPECT_TRUE(IsSeen("unknown command 'spere'"));
  EXPECT_TRUE(SceneIs("small.scn"));
}

TEST_F(SlowScenes, LetOneEditFollowTheOther) {
  Drop("slow.scn");
  viewer_->WaitForScene();
  ChooseNode(viewer_->state(), viewer_->scene().world.Nodes().size() - 1);
  SceneEditor& editor = viewer_->state().editor;
  editor.MoveBySteps(1);
  ASSERT_TRUE(viewer_->IsReading());
  EXPECT_EQ(editor.Describe(), "none") << "it is done once it is read";
  editor.MoveBySteps(1);
  EXPECT_EQ(viewer_->Message().substr(0, 22), "wait: reading slow.scn");
  editor.Undo();
  EXPECT_EQ(viewer_->Message(), "nothing to undo");
  Happen("key Control+S");
  EXPECT_EQ(viewer_->Message().substr(0, 22), "wait: reading slow.scn") << "what is not read yet is not saved";
  ChangeOption(viewer_->state(), "accelerator", "grid");
  EXPECT_EQ(viewer_->Message().substr(0, 22), "wait: reading slow.scn");
  // Whoever opens another scene now would lose the edit.
  Drop("small.scn");
  EXPECT_NE(viewer_->Message().find("unsaved changes"), std::string::npos) << viewer_->Message();
  viewer_->WaitForScene();
  EXPECT_TRUE(SceneIs("slow.scn"));
  EXPECT_EQ(editor.Describe(), "1 change, not saved");
}

// A slider that is let go while what it was dragged to before is still being read.
TEST_F(SlowScenes, TakeTheLastOfADrag) {
  Drop("slow.scn");
  viewer_->WaitForScene();
  SceneEditor& editor = viewer_->state().editor;
  editor.SetSetting("width", "100", false);
  ASSERT_TRUE(viewer_->IsReading());
  editor.SetSetting("width", "110", true);
  editor.SetSetting("width", "120", true);
  editor.DoHeld();
  viewer_->WaitForScene();
  EXPECT_NE(editor.Describe().find("not saved"), std::string::npos);
  std::string text;
  for (const auto& [file, bytes] : *viewer_->state().settings.parse.edited) text += bytes;
  EXPECT_NE(text.find("120"), std::string::npos) << text;
  EXPECT_EQ(text.find("110"), std::string::npos) << text;
}

}  // namespace
}  // namespace ray
