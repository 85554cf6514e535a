// Whoever leans on the keyboard must not lose an image: nothing that a user does in whatever order breaks the viewer.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <optional>
#include <thread>
#include <vector>

#include "source/view/EventScript.h"
#include "source/view/KeyBindings.h"
#include "source/view/Viewer.h"
#include "tests/Draw.h"
#include "tests/source/view/CopiedScenes.h"
#include "tests/source/view/WithOptions.h"

namespace ray {
namespace {

/// A user who does anything at all.
class RandomUser {
 public:
  explicit RandomUser(std::uint64_t seed) : draw_(seed) { Open(); }

  void Act() {
    switch (draw_.Whole(0, 15)) {
      case 0:
      case 1:
      case 2:
      case 3:
      case 4:
        return PressKey();
      case 5:
      case 6:
        return Do(MoveEvent{X(), Y()});
      case 7:
        return Do(ButtonEvent{AButton(), draw_.Whole(0, 1) == 1, X(), Y(), SomeModifiers()});
      case 8:
        return Click(X(), Y());
      case 9:
      case 10:
        return ClickPanel();
      case 11:
        return Do(ScrollEvent{draw_.Between(-3, 3), X(), Y()});
      case 12:
      case 13:
        return Do(TickEvent{draw_.Scale(-3, 0)});
      case 14:
        return draw_.Whole(0, 1) ? Type() : EditScene();
      default:
        return DoWhatIsRare();
    }
  }

  /// What holds whatever was done.
  void Check() {
    viewer_->Update();
    const Camera& camera = viewer_->navigator().camera();
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_TRUE(std::isfinite(camera.eye[axis]));
      ASSERT_NEAR(Length(camera.towards), 1, 1e-9);
      ASSERT_NEAR(Length(camera.up), 1, 1e-9);
    }
    const FrameState shown = viewer_->Show();
    ASSERT_GE(shown.view.width, 1);
    ASSERT_LE(shown.view.width, shown.size.width);
    for (const auto& picture : {shown.quad, shown.covering}) {
      if (!picture) continue;
      ASSERT_NE(picture->frame == nullptr, picture->image == nullptr) << "either a frame or an image";
      if (picture->frame) picture->frame->At(0, picture->frame->Height() - 1);
    }
    if (!shown.panels) return;
    for (const PanelDrawing::Part& part : shown.panels->parts)
      ASSERT_LE(part.first + part.count, shown.panels->indices.size());
    for (const std::uint32_t corner : shown.panels->indices) ASSERT_LT(corner, shown.panels->corners.size());
  }

  /// Whether key S still makes the image that the same settings make without a viewer.
  void CheckRendering() {
    for (int i = 0; i < 3; ++i) Do(ButtonEvent{static_cast<Button>(i), false, 1, 1, {}});
    viewer_->WaitForScene();
    if (viewer_->state().shows.help) Do(KeyEvent{Key::escape, {}, true});  // what is typed is searched for there
    if (viewer_->state().shows.panels) Do(KeyEvent{Key::tab, {}, true});
    Do(ResizeEvent{24, 16, 1});
    host_.traced.clear();
    host_.traced_settings.clear();
    Do(KeyEvent{Key::s, {}, true});
    while (viewer_->Traced().IsUnsaved()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      viewer_->Update();
    }
    ASSERT_EQ(host_.traced.size(), 1u) << viewer_->Message();
    const LoadedScene& scene = viewer_->scene();
    EXPECT_EQ(host_.traced[0], Render(scene.world, *scene.accelerator, host_.traced_settings[0]).image);
  }

  /// What was done, for rayview -headless -events.
  const std::string& Script() const { return script_; }
  /// How often the scene was changed, and saved.
  int Edits() const { return edits_; }
  int Saves() const { return saves_; }
  /// How often a crop was dragged, and a number or a color changed by its slider or swatch.
  int Crops() const { return crops_; }
  int Slides() const { return slides_; }

 private:
  void Open() {
    std::ofstream(folder_ / "broken.scn") << "spere -1  0 0 0  1\n";
    std::ofstream(folder_ / "including.scn") << "include hello.scn\ninclude glass.scn\n";
    std::ofstream(folder_ / "mine.rays") << "pixel 3 4\ncamera 0 2 7  0 0 0\nshadow 0 0 0  1 5 2\n";
    for (const char* scene : {"fisheye.scn", "csg.scn", "camera_motion.scn"})
      std::filesystem::copy(project::Root() / "scenes" / scene, folder_ / scene);
    ViewerSettings settings;
    // Every fifth user begins with the start page, without a scene.
    if (draw_.Whole(0, 4) > 0) settings.scene = folder_ / "hello.scn";
    settings.shows_traced = draw_.Whole(0, 1) == 1;
    settings.render.width = settings.render.height = 48;
    settings.budget_of_rest = settings.shows_bar = true;
    const auto scene = settings.scene.empty()
                           ? std::make_shared<const LoadedScene>(ParsedScene{}, settings.accelerator)
                           : std::make_shared<const LoadedScene>(settings.scene, settings.parse, settings.accelerator);
    viewer_ = std::make_unique<Viewer>(settings, scene, host_);
  }
  void Do(const Event& event) {
    script_ += ScriptLine(event);
    const std::size_t done = viewer_->state().editor.History().Done();
    const std::string before = viewer_->Message();
    viewer_->Handle(event);
    if (++events_ % 4 > 0) viewer_->WaitForScene();  // else the next event comes meanwhile
    edits_ += viewer_->state().editor.History().Done() > done;
    saves_ += viewer_->Message() != before && viewer_->Message().find("saved ") != std::string::npos;
  }

  void PressKey() {
    const auto& bindings = KeyBindings();
    const auto& binding = bindings[static_cast<std::size_t>(draw_.Whole(0, static_cast<int>(bindings.size()) - 1))];
    const bool is_bound = draw_.Whole(0, 4) > 0;
    const Key key = is_bound ? binding.key : static_cast<Key>(draw_.Whole(0, static_cast<int>(Key::pad_9)));
    const Modifiers modifiers = is_bound ? binding.modifiers : SomeModifiers();
    Do(KeyEvent{key, modifiers, true});
    if (draw_.Whole(0, 9) > 0) Do(KeyEvent{key, modifiers, false});
  }

  void Click(double x, double y) {
    const Button button = AButton();
    const Modifiers modifiers = SomeModifiers();
    Do(ButtonEvent{button, true, x, y, modifiers});
    Do(ButtonEvent{button, false, x, y, modifiers});
  }

  void DragCrop() {
    constexpr Modifiers control{.control = true};
    const double x = X(), y = Y();
    Do(ButtonEvent{Button::right, true, X(), Y(), control});
    Do(MoveEvent{x, y});
    Do(ButtonEvent{Button::right, false, x, y, control});
    crops_ += viewer_->state().crop.has_value();
  }

  /// The numbers of a material are changed, by a slider where it has any.
  void EditMaterial() {
    const DrawingSize before = viewer_->Size();
    if (viewer_->state().shows.help) Do(KeyEvent{Key::escape, {}, true});
    if (!viewer_->state().shows.panels) Do(KeyEvent{Key::tab, {}, true});
    Do(ResizeEvent{400, 1600, 1});  // so that all of a panel is seen
    if (!AnItem("Material")) ClickItem("Scene");
    if (!AnItem("material")) ClickItem("Material");
    ClickItem("material");
    const std::size_t done = viewer_->state().editor.History().Done();
    if (const auto slider = AnItem("slide ")) {
      const double x = slider->x + draw_.Between(-60, 60);
      Do(ButtonEvent{Button::left, true, x, slider->y, {}});
      Do(MoveEvent{x + draw_.Between(-20, 20), slider->y});
      Do(ButtonEvent{Button::left, false, x, slider->y, {}});
    }
    slides_ += viewer_->state().editor.History().Done() > done;
    Do(ResizeEvent{before.width, before.height, 1});
  }

  /// One of the things in the panels whose names begin so; nothing where there are none.
  std::optional<PanelItem> AnItem(const std::string& start) {
    viewer_->Show();
    std::vector<PanelItem> found;
    for (const PanelItem& item : viewer_->ItemsOfPanels())
      if (item.name.starts_with(start)) found.push_back(item);
    if (found.empty()) return {};
    return found[static_cast<std::size_t>(draw_.Whole(0, static_cast<int>(found.size()) - 1))];
  }
  void ClickItem(const std::string& start) {
    const auto item = AnItem(start);
    if (!item) return;
    Do(ButtonEvent{Button::left, true, item->x, item->y, {}});
    Do(ButtonEvent{Button::left, false, item->x, item->y, {}});
  }

  void ClickPanel() {
    viewer_->Show();
    const auto& items = viewer_->ItemsOfPanels();
    if (items.empty()) return Click(X(), Y());
    const PanelItem item = items[static_cast<std::size_t>(draw_.Whole(0, static_cast<int>(items.size()) - 1))];
    Do(ButtonEvent{Button::left, true, item.x, item.y, {}});
    Do(ButtonEvent{Button::left, false, item.x, item.y, {}});
  }

  /// Something that is shown is chosen, changed, and maybe saved or changed back.
  void EditScene() {
    constexpr Modifiers control{.control = true}, both{true, true};
    if (viewer_->state().shows.help) Do(KeyEvent{Key::escape, {}, true});
    const double x = X(), y = Y();
    Do(ButtonEvent{Button::left, true, x, y, {}});
    Do(ButtonEvent{Button::left, false, x, y, {}});
    constexpr std::array changes{std::pair{Key::equal, Modifiers{}}, std::pair{Key::minus, Modifiers{true, false}},
                                 std::pair{Key::d, control},         std::pair{Key::del, Modifiers{}},
                                 std::pair{Key::k, control},         std::pair{Key::k, Modifiers{true, false}}};
    constexpr std::array then{std::pair{Key::z, control}, std::pair{Key::y, control}, std::pair{Key::s, control},
                              std::pair{Key::s, both}};
    const auto& change = changes[static_cast<std::size_t>(draw_.Whole(0, changes.size() - 1))];
    Do(KeyEvent{change.first, change.second, true});
    const auto& next = then[static_cast<std::size_t>(draw_.Whole(0, then.size() - 1))];
    Do(KeyEvent{next.first, next.second, true});
  }

  void Type() {
    constexpr std::array texts{"16", "e", "-1e999", "\xC3\xA9", "\xFF\xFE", "%s%n", "hello"};
    Do(TextEvent{texts[static_cast<std::size_t>(draw_.Whole(0, static_cast<int>(texts.size()) - 1))]});
  }

  void DoWhatIsRare() {
    constexpr std::array files{"hello.scn",    "glass.scn",   "empty.scn",  "broken.scn",
                               "nothing.scn",  "meshes",      "fisheye.scn", "csg.scn",
                               "camera_motion.scn", "including.scn", "mine.rays"};
    switch (draw_.Whole(0, 9)) {
      case 9:
      case 8:
        return DragCrop();
      case 7:
      case 6:
        return EditMaterial();
      case 0:
        return Do(DropEvent{folder_ / files[static_cast<std::size_t>(draw_.Whole(0, files.size() - 1))]});
      case 1:
        return Do(DropEvent{"picture"});
      case 2:
        return Do(CloseEvent{});
      case 3:
        std::ofstream(folder_ / "hello.scn", std::ios::app) << "box -1  0 0 0  .1 .1 .1\n";
        return;
      default:
        return Do(ResizeEvent{draw_.Whole(0, 80), draw_.Whole(0, 80), draw_.Whole(0, 3) ? 1.0 : 2.0});
    }
  }

  /// Within the drawing, but for one in eight.
  double X() { return Position(viewer_->Size().width); }
  double Y() { return Position(viewer_->Size().height); }
  double Position(int size) {
    return draw_.Whole(0, 7) ? draw_.Between(0, size) : (draw_.Whole(0, 1) ? 1 : -1) * draw_.Scale(0, 6);
  }
  Button AButton() { return static_cast<Button>(draw_.Whole(0, 2)); }
  Modifiers SomeModifiers() { return {.shift = draw_.Whole(0, 3) == 0, .control = draw_.Whole(0, 3) == 0}; }

  Draw draw_;
  std::string script_ = "origin bottom\n";
  int events_ = 0, edits_ = 0, saves_ = 0, crops_ = 0, slides_ = 0;
  CopiedScenes folder_;
  WithOptions host_;
  std::unique_ptr<Viewer> viewer_;
};

TEST(RandomEvents, TwentyThousandOfThemDoNoHarm) {
  // In several stories, so that a failure is short enough to be read, and each begins with a viewer as it is at first.
  constexpr int events_of_a_story = 250;
  const int stories = Count(4, 80);
  int edits = 0, saves = 0, crops = 0, slides = 0;
  for (int story = 0; story < stories && !testing::Test::HasFailure(); ++story) {
    RandomUser user(2'000 + static_cast<std::uint64_t>(story));
    for (int i = 0; i < events_of_a_story && !testing::Test::HasFailure(); ++i) {
      user.Act();
      user.Check();
    }
    user.CheckRendering();
    edits += user.Edits(), saves += user.Saves(), crops += user.Crops(), slides += user.Slides();
    if (testing::Test::HasFailure()) FAIL() << "story " << story << ":\n" << user.Script();
  }
  EXPECT_GE(edits, stories) << "scenes were hardly changed";
  EXPECT_GE(saves, stories / 2) << "and hardly saved";
  EXPECT_GE(crops, stories / 2);
  EXPECT_GE(slides, std::max(1, stories / 8));
}

}  // namespace
}  // namespace ray
