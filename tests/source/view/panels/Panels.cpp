#include "source/view/panels/Panels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "source/scene/CameraText.h"
#include "source/text/NumberText.h"
#include "source/view/KeyBindings.h"
#include "source/view/commands/Commands.h"
#include "tests/source/view/panels/PanelTest.h"

namespace ray {
namespace {

TEST_F(PanelTest, AreHiddenUntilTabShowsThem) {
  EXPECT_FALSE(viewer_->Show().panels);
  Do("key Tab");
  const auto panels = viewer_->Show().panels;
  ASSERT_TRUE(panels);
  EXPECT_FALSE(viewer_->ItemsOfPanels().empty());
  Do("key Tab\ntick 10");  // no message is left
  EXPECT_FALSE(viewer_->Show().panels);
  EXPECT_TRUE(viewer_->ItemsOfPanels().empty());
}

TEST_F(PanelTest, LeaveHalfOfASmallDrawingUncovered) {
  Do("key Tab\ntick 10");  // no message is left
  const FrameState shown = viewer_->Show();
  EXPECT_GE(shown.view.width, width / 2);
  const auto bar_top = static_cast<float>(shown.view.height) - 0.1F;
  for (const PanelDrawing::Corner& corner : shown.panels->corners)
    EXPECT_TRUE(corner.x >= static_cast<float>(shown.view.width) || corner.y >= bar_top)
        << corner.x << ' ' << corner.y;
}

TEST_F(PanelTest, StayInTheDrawingAndOnTheirSheet) {
  for (const char* size : {"512 512", "1280 800", "1024 1024 2", "64 48", "1 1"}) {
    Do(std::string("resize ") + size);
    if (!viewer_->state().shows.panels) Do("key Tab");
    const auto panels = viewer_->Show().panels;
    const DrawingSize drawing = viewer_->Size();
    for (const PanelDrawing::Part& part : panels->parts) {
      EXPECT_TRUE(part.left >= 0 && part.top >= 0 && part.right <= drawing.width && part.bottom <= drawing.height)
          << size;
      ASSERT_LE(part.first + part.count, panels->indices.size());
    }
    for (const std::uint32_t index : panels->indices) ASSERT_LT(index, panels->corners.size());
    for (const PanelDrawing::Corner& corner : panels->corners)
      EXPECT_TRUE(corner.u >= 0 && corner.u <= 1 && corner.v >= 0 && corner.v <= 1);
  }
}

TEST_F(PanelTest, HaveLargerLettersOnDenserScreens) {
  Do("key Tab");
  const int once = viewer_->Show().panels->sheet->width * viewer_->Show().panels->sheet->height;
  Do("resize 1024 1024 2");
  EXPECT_GT(viewer_->Show().panels->sheet->width * viewer_->Show().panels->sheet->height, once);
}

TEST_F(PanelTest, HaveMessagesAsLargeAsTheirLetters) {
  const auto width_of_message = [&] {
    Do("key E\nkey E");  // "edges off"
    const FrameState shown = viewer_->Show();
    float left = 1e6F, right = 0;
    for (const PanelDrawing::Corner& corner : shown.panels->corners)
      left = std::min(left, corner.x), right = std::max(right, corner.x);
    return right - left;
  };
  const float usual = width_of_message();
  Do("resize 1024 1024 2");
  EXPECT_NEAR(width_of_message(), 2 * usual, 0.2 * usual);  // letters are whole pixels wide
  SetPanelLook(viewer_->state(), {PanelTheme::dark, 2});
  EXPECT_NEAR(width_of_message(), 4 * usual, 0.2 * usual);
}

TEST_F(PanelTest, LabelsStandWhereTheySayOverADarkGround) {
  Do("key E");
  const FrameState shown = viewer_->Show();
  ASSERT_EQ(shown.labels.size(), 1u);
  const Label& label = shown.labels[0];
  const LetterSize letters = MakePanels()->Letters();
  constexpr double margin = 2;
  // The ground comes first, and letters within it.
  double left = 1e6, right = 0, top = 1e6, bottom = 0;
  for (const PanelDrawing::Corner& corner : shown.panels->corners) {
    left = std::min<double>(left, corner.x), right = std::max<double>(right, corner.x);
    top = std::min<double>(top, corner.y), bottom = std::max<double>(bottom, corner.y);
  }
  EXPECT_NEAR(left, label.x - margin, 0.5);
  EXPECT_NEAR(right, label.x + letters.width * static_cast<double>(label.text.size()) + margin, 0.5);
  EXPECT_NEAR(bottom, shown.size.height - label.y, 0.5);
  EXPECT_NEAR(bottom - top, letters.height, 0.5);
  EXPECT_EQ(shown.panels->corners.front().color, (Rgba{0, 0, 0, Label::ground_alpha}));
}

// Names of files have accents, dashes and other alphabets.
TEST_F(PanelTest, LabelsHaveLettersOfTheirOwnForOtherAlphabets) {
  const auto drawn = [&](const char* name) {
    Do(std::string("drop ") + name);
    std::vector<std::pair<float, float>> on_sheet;
    const auto panels = viewer_->Show().panels;
    for (const PanelDrawing::Corner& corner : panels->corners) on_sheet.emplace_back(corner.u, corner.v);
    return on_sheet;
  };
  const auto plain = drawn("u.png"), accent = drawn("\u00fc.png"), cyrillic = drawn("\u0443.png"),
             dash = drawn("\u2013.png");
  EXPECT_EQ(plain.size(), accent.size());
  EXPECT_NE(plain, accent);
  EXPECT_NE(accent, cyrillic);
  EXPECT_NE(cyrillic, dash);
}

TEST_F(PanelTest, AreAsWideAsTheirEdgeIsDragged) {
  const auto left_edge = [&] { return viewer_->Show().view.width; };
  Do("key Tab");
  const int before = left_edge();
  const std::string y = " 20", from = std::to_string(before + 1) + y;
  Do("drag left " + from + " " + std::to_string(before - 99) + y);
  EXPECT_NEAR(left_edge(), before - 100, 2);
  EXPECT_NEAR(viewer_->state().panels->Look().width, width - before + 100, 2) << "it is told, to be kept";
  Do("resize 256 512");
  EXPECT_GT(left_edge(), 0) << "some of a small picture can still be clicked";
}

// A window that was small for a moment left panels of 130 pixels for ever.
TEST_F(PanelTest, RegainTheirWidthOnceTheWindowGrowsBack) {
  Do("resize 1000 700\nkey Tab");
  viewer_->Show();
  const int before = viewer_->Show().view.width;
  Do("resize 150 200");
  viewer_->Show();
  Do("resize 1000 700");
  viewer_->Show();
  EXPECT_EQ(viewer_->Show().view.width, before);
  EXPECT_EQ(viewer_->state().panels->Look().width, 0) << "nothing was dragged, and nothing is kept";
}

TEST_F(PanelTest, ANodeThatIsClickedIsToldAndBoxed) {
  Do("key Tab");
  const std::size_t lines = viewer_->Show().lines->size();
  Click("cone, line 18");
  ASSERT_TRUE(viewer_->state().selection.node);
  EXPECT_EQ(viewer_->scene().world.Nodes()[*viewer_->state().selection.node].node->location.line, 18);
  EXPECT_TRUE(Says("hello.scn:18")) << viewer_->TextOfPanels();
  EXPECT_EQ(viewer_->Show().lines->size(), lines + 2 * 12) << "a box has twelve edges";
  Click("deselect");
  EXPECT_FALSE(viewer_->state().selection.node);
}

TEST_F(PanelTest, TheChosenNodeCanBeFramed) {
  Do("key Tab");
  Click("cylinder");
  const std::string before = CameraLine(viewer_->navigator().camera());
  Click("frame");
  EXPECT_NE(CameraLine(viewer_->navigator().camera()), before);
}

TEST_F(PanelTest, AGroupOpensByItsArrow) {
  Do("key Tab");
  EXPECT_FALSE(HasItem("mesh of"));
  const auto group = Find("group of 1");
  ASSERT_TRUE(group);
  const int left = viewer_->Show().view.width;
  constexpr int to_arrow = 29;  // pixels from the column's edge
  Do("click left " + std::to_string(left + to_arrow) + " " + std::to_string(group->y));
  EXPECT_TRUE(HasItem("mesh of")) << viewer_->TextOfPanels();
}

TEST_F(PanelTest, PickingInTheImageSelectsTheTreeNode) {
  Do("key Tab\nclick left 200 250");
  ASSERT_TRUE(viewer_->Picked() && viewer_->Picked()->point);
  ASSERT_TRUE(viewer_->state().selection.node);
  EXPECT_EQ(viewer_->scene().world.Nodes()[*viewer_->state().selection.node].instance,
            static_cast<std::int32_t>(viewer_->Picked()->instance));
}

TEST_F(PanelTest, KeepTheirClicksDragsAndScrollsFromTheImage) {
  Do("key Tab");
  const std::string before = CameraLine(viewer_->navigator().camera());
  Do("click left 400 100\nclick right 400 100\ndrag left 400 100 100 300\nscroll 3 400 100");
  EXPECT_EQ(CameraLine(viewer_->navigator().camera()), before);
  EXPECT_FALSE(viewer_->Picked());
  EXPECT_FALSE(viewer_->Rays().Pixel());
}

TEST_F(PanelTest, ADragFromTheImageMayEndOverThem) {
  Do("key Tab\ndrag left 100 100 400 100\ndrag left 100 100 400 100");
  EXPECT_FALSE(viewer_->navigator().IsDragging());
  const std::string turned = CameraLine(viewer_->navigator().camera());
  const DrawingSize view = viewer_->Show().view;
  Open(project::Root() / "scenes/hello.scn");
  Do("resize " + std::to_string(view.width) + " " + std::to_string(view.height) +
     "\ndrag left 100 100 400 100\ndrag left 100 100 400 100");
  EXPECT_EQ(CameraLine(viewer_->navigator().camera()), turned) << "as in a window as large as the view beside them";
}

TEST_F(PanelTest, RaysOfAPixelAreListedWithWhatTheyContribute) {
  Do("key Tab\nclick right 102 " + std::to_string(253 + viewer_->state().panels->HeightOfBar()));
  const PixelTrace& pixel = *viewer_->Rays().Pixel();
  ASSERT_EQ(pixel.samples.size(), 1u);
  const auto root = Find("camera ");
  ASSERT_TRUE(root) << viewer_->TextOfPanels();
  EXPECT_NE(root->name.find("sphere, line 16"), std::string::npos) << root->name;
  // The rays of a sample add up to it.
  Click("camera ");
  const std::string text = viewer_->TextOfPanels();
  ASSERT_NE(text.find("subtree "), std::string::npos) << text;
  std::istringstream sum(text.substr(text.rfind("subtree ") + 8));
  R2::Color total;
  sum >> total.r >> total.g >> total.b;
  EXPECT_NEAR(total.r, pixel.Mean().r, 1e-3);
  EXPECT_NEAR(total.g, pixel.Mean().g, 1e-3);
  EXPECT_NEAR(total.b, pixel.Mean().b, 1e-3);
  EXPECT_TRUE(HasItem("shadow ")) << "its children are listed at once";
}

TEST_F(PanelTest, AChosenRayStaysLitUntilClickedAgain) {
  Do("key Tab\nclick right 200 250");
  EXPECT_FALSE(viewer_->Show().lit);
  Click("reflection ");
  const auto chosen = viewer_->Rays().Look().chosen;
  ASSERT_TRUE(chosen);
  EXPECT_EQ(viewer_->Rays().Pixel()->rays[*chosen].kind, RayKind::reflection);
  const FrameState shown = viewer_->Show();
  ASSERT_TRUE(shown.lit);
  const DrawingSpace space = DrawingSpace::Of(viewer_->scene().parsed.scene.root.bounds);
  const R3::Ray& ray = viewer_->Rays().Pixel()->rays[*chosen].ray;
  EXPECT_EQ(shown.lit->front().at, space.At(ray.At(ray.t_min)));
  EXPECT_TRUE(Says("along ")) << viewer_->TextOfPanels();
  Do("tick 1");  // else it would be a double click
  Click("reflection ");
  EXPECT_FALSE(viewer_->Rays().Look().chosen);
}

TEST_F(PanelTest, AnotherPixelHasNoChosenRay) {
  Do("key Tab\nclick right 200 250");
  Click("reflection ");
  Do("key Right");
  EXPECT_FALSE(viewer_->Rays().Look().chosen);
  EXPECT_FALSE(viewer_->Show().lit);
}

TEST_F(PanelTest, AnOptionIsChosenFromAListOfItsValues) {
  Do("resize 800 800\nkey Tab");
  Click("Scene");
  Click("Render");
  Click("light");
  Click("-mode");
  Click("path");
  EXPECT_EQ(host_.mode, "path");
  EXPECT_EQ(viewer_->state().SettingsOfView().mode, RenderMode::path);
}

TEST_F(PanelTest, AnOptionIsTypedAndTheImageStartsOver) {
  Open(project::Root() / "scenes/sphere.scn");
  Do("resize 800 800\nkey Tab\nkey P\nwait trace");
  Click("Scene");
  Click("Render");
  Click("light");
  Click("-samples");
  const std::uint64_t before = viewer_->Traced().JobNumber();
  Do("key Control+A\ntype 4");
  EXPECT_EQ(host_.samples, 1) << "until Enter";
  Do("key Enter\nwait trace");
  EXPECT_EQ(host_.samples, 4);
  EXPECT_EQ(viewer_->state().SettingsOfView().samples, 4);
  EXPECT_GT(viewer_->Traced().JobNumber(), before);
  EXPECT_TRUE(Says("make -samples 4")) << viewer_->TextOfPanels();
}

TEST_F(PanelTest, AWrongValueIsRefusedAndTold) {
  Do("resize 800 800\nkey Tab");
  Click("Scene");
  Click("Render");
  Click("light");
  Click("-samples");
  Do("key Control+A\ntype many\nkey Enter");
  EXPECT_EQ(viewer_->state().SettingsOfView().samples, 1);
  EXPECT_TRUE(Says("-samples must be 1 to 9, got many")) << viewer_->TextOfPanels();
}

TEST_F(PanelTest, KeysThatAreTypedIntoAFieldDoNothingElse) {
  Do("resize 800 800\nkey Tab");
  Click("Scene");
  Click("Render");
  Click("light");
  Click("-samples");
  const FrameState before = viewer_->Show();
  Do("key E\ntype e\nkey Escape");
  EXPECT_FALSE(viewer_->Show().shows_edges);
  EXPECT_EQ(host_.samples, 1);
  Do("key E");
  EXPECT_TRUE(viewer_->Show().shows_edges) << "Escape gave the keys back";
}

TEST_F(PanelTest, KeysAreTheViewersAgainRightAfterEnter) {
  Do("resize 800 800\nkey Tab");
  Click("Scene");
  Click("Render");
  Click("light");
  Click("-samples");
  Do("key Control+A\ntype 2\nkey Enter\nkey E");
  EXPECT_EQ(host_.samples, 2);
  EXPECT_TRUE(viewer_->Show().shows_edges);
}

TEST_F(PanelTest, OptionsStayWhileTheImageIsRendered) {
  Do("resize 800 800\nkey Tab");
  Click("Scene");
  Click("Render");
  Click("light");
  viewer_->Handle(KeyEvent{Key::s, {}, true});
  Click("-mode");
  Click("path");
  EXPECT_EQ(host_.mode, "whitted");
  EXPECT_FALSE(viewer_->state().option_changes.problem.empty());
}

TEST_F(PanelTest, TheCommandIsCopied) {
  Do("resize 800 800\nkey Tab");
  Click("Scene");
  Click("Render");
  Click("copy the command");
  EXPECT_EQ(host_.clipboard, "make -samples 1\n");
}

TEST_F(PanelTest, AChosenLayersNumbersAreThoseOfTheImage) {
  Open(project::Root() / "scenes/sphere.scn");
  Do("resize 256 256\nkey Tab");
  Click("Scene");
  Click("Pixel");
  Click("Image");
  Click("live");
  Click("depth");
  Do("wait trace\nmove 40 128");  // beside the panels
  const auto x = static_cast<int>(viewer_->state().PointerInShownImage().x),
             y = static_cast<int>(viewer_->state().PointerInShownImage().y);
  const RenderJob* job = viewer_->Traced().Live();
  ASSERT_TRUE(job);
  EXPECT_EQ(job->Settings().mode, RenderMode::depth);
  const R2::Image picture = Render(viewer_->scene().world, *viewer_->scene().accelerator, job->Settings()).image;
  float nearest = 1e9F, farthest = 0;
  for (const float depth : picture.Channels())
    if (depth > 0) nearest = std::min(nearest, depth), farthest = std::max(farthest, depth);
  const std::string bar =
      Rounded(nearest, 4) + " " + Rounded((nearest + farthest) / 2.0, 4) + " " + Rounded(farthest, 4);
  EXPECT_TRUE(Says(bar)) << bar << "\n" << viewer_->TextOfPanels();
  ASSERT_GT(picture.At(x, y).r, 0) << "the ball is there";
  EXPECT_TRUE(Says("pixel " + std::to_string(x) + " " + std::to_string(y))) << viewer_->TextOfPanels();
  EXPECT_TRUE(Says("value " + Rounded(picture.At(x, y).r, 4))) << viewer_->TextOfPanels();
  Click("live");
  Click("off");
  EXPECT_FALSE(viewer_->Traced().IsLive());
}

TEST_F(PanelTest, StatisticsAreThoseOfTheRender) {
  Open(project::Root() / "scenes/sphere.scn");
  Do("resize 256 256\nkey Tab");
  Click("Scene");
  Click("Pixel");
  Click("Render");
  EXPECT_TRUE(Says("Nothing is rendered yet"));
  Do("key P\nwait trace");
  const RenderResult& result = *viewer_->Traced().Live()->Result();
  EXPECT_TRUE(Says("camera | " + std::to_string(result.rays[RayKind::camera].rays))) << viewer_->TextOfPanels();
  EXPECT_TRUE(Says("all | " + std::to_string(result.rays.Total()))) << viewer_->TextOfPanels();
}

TEST_F(PanelTest, AcceleratorsAreComparedAndOneIsTaken) {
  Do("resize 800 800\nkey Tab");
  Click("Scene");
  Click("Pixel");
  Click("Render");
  EXPECT_FALSE(HasItem("octree"));
  Click("compare all");
  EXPECT_TRUE(HasItem("stop") || !viewer_->IsBusy()) << "the window goes on meanwhile";
  WaitUntilIdle();
  for (const AcceleratorKind* kind : AcceleratorKinds())
    EXPECT_EQ(HasItem(kind->name), std::string(kind->name) != "auto") << kind->name;
  Click("octree");
  EXPECT_EQ(host_.accelerator, "octree");
  EXPECT_EQ(viewer_->scene().accelerator->kind, "octree");
}

TEST_F(PanelTest, MistakesOfAnEditedSceneAreShownWithTheirPlaces) {
  const project::Folder folder;
  const auto file = folder / "scene.scn";
  const auto write = [&](const std::string& text) { folder.Write("scene.scn", text); };
  write("sphere -1  0 0 0  1\n");
  Open(file);
  Do("key Tab");
  EXPECT_FALSE(HasItem("Errors"));
  write("sphere -1  0 0 0  1\nspere -1  0 0 0  1\n");
  Do("key Control+R");
  EXPECT_TRUE(HasItem("Errors"));
  const std::string text = viewer_->TextOfPanels();
  EXPECT_NE(text.find(file.string() + ":2:1"), std::string::npos) << text;
  EXPECT_NE(text.find("2 | spere -1  0 0 0  1\n    ^~~~~"), std::string::npos) << text;
  EXPECT_NE(text.find("did you mean 'sphere'"), std::string::npos) << text;
  write("sphere -1  0 0 0  2\n");
  Do("key Control+R");
  EXPECT_FALSE(HasItem("Errors"));
}

TEST_F(PanelTest, HaveALightThemeAndLargerLetters) {
  Do("resize 512 1024\nkey Tab");
  Click("Scene");
  Click("View");
  Do("tick 10");  // no message is left
  const auto before = viewer_->Show().panels;
  Click("light theme");
  const auto light = viewer_->Show().panels;
  const auto brightness = [](const PanelDrawing& panels) { return panels.corners.front().color[0]; };
  EXPECT_GT(brightness(*light), brightness(*before));
  Click("larger");
  EXPECT_EQ(viewer_->state().panels->Look(), (PanelSettings{PanelTheme::light, 1.25}));
  EXPECT_NE(viewer_->Show().panels->sheet, light->sheet);
  for (int i = 0; i < 20; ++i) Click("smaller");
  EXPECT_EQ(viewer_->state().panels->Look().letters, smallest_letters);
}

TEST_F(PanelTest, WhatKeysSwitchIsSwitchedInTheDisplayPanelToo) {
  Do("resize 512 1200\nkey Tab");
  for (const char* open : {"Scene", "Pixel", "View"}) Click(open);
  const auto& overlays = viewer_->state().overlays;
  Click("faces");
  EXPECT_FALSE(overlays.faces);
  EXPECT_EQ(viewer_->Message(), "faces off");
  Click("edges");
  EXPECT_TRUE(overlays.edges);
  Click("lights");
  EXPECT_TRUE(overlays.lights);
  Click("rays of every 25th pixel");
  EXPECT_TRUE(viewer_->state().rays.ShowsGrid());
  Click("level horizon");
  EXPECT_FALSE(viewer_->navigator().IsTurntable());
}

TEST_F(PanelTest, TheDisplayPanelSetsBoxesCutsAndViewAngle) {
  Do("resize 512 1200\nkey Tab");
  for (const char* open : {"Scene", "Pixel", "View"}) Click(open);
  const auto& overlays = viewer_->state().overlays;
  Click("boxes of the accelerator");
  EXPECT_EQ(overlays.boxes, SpaceOverlays::Boxes::accelerator);
  Click("slide level");
  EXPECT_GT(overlays.box_level, all_levels);
  Click("cut along yz");
  EXPECT_TRUE(viewer_->state().section.IsShown());
  EXPECT_EQ(viewer_->state().section.Plane(), SlicePlane::yz);
  Click("cut along a row");
  EXPECT_EQ(viewer_->state().section.Plane(), SlicePlane::camera_row);
  Click("no cut");
  EXPECT_FALSE(viewer_->state().section.IsShown());
  const double before = viewer_->navigator().camera().xfov;
  Click("slide view angle");
  EXPECT_GT(viewer_->navigator().camera().xfov, before) << "the middle of the slider is a wide angle";
  EXPECT_NEAR(viewer_->navigator().camera().Fov(), 77.5, 2);
}

// It was stretched over what the panels left of the view.
TEST_F(PanelTest, TheTracedImageIsTracedAgainForTheViewBesideThem) {
  viewer_->state().traced.ShowLive({});
  const auto check = [&](const char* key) {
    Do(std::string("key ") + key + "\nwait trace");
    const Frame& frame = viewer_->Traced().ShownLive()->frame();
    const DrawingSize view = viewer_->Show().view;
    EXPECT_EQ(frame.Width(), view.width) << key;
    EXPECT_EQ(frame.Height(), view.height) << key;
    return view.width;
  };
  const int beside_panels = check("Tab"), beside_both = check("X");
  EXPECT_LT(beside_panels, 512);
  EXPECT_LT(beside_both, beside_panels);
  EXPECT_GT(check("Tab"), beside_both);
}

TEST_F(PanelTest, LeaveTheCutBesideThem) {
  Do("resize 1000 600\nkey X\nkey Tab");
  const FrameState shown = viewer_->Show();
  EXPECT_LT(shown.view.width + shown.section_size.width, shown.size.width);
  EXPECT_NEAR(shown.view.width, shown.section_size.width, 1);
}

// The press went to the image and its release to panels that had come up meanwhile: the view kept flying, and S with
// it.
TEST_F(PanelTest, ADragThatPanelsComeUpInStillEnds) {
  Do("key Tab\ndown left 500 256\nkey Tab\ndown right 20 20\nkey Tab\nup right 20 20\nkey S\nwait trace");
  EXPECT_EQ(host_.traced.size(), 1u) << viewer_->Message();
}

TEST_F(PanelTest, AnotherSceneIsAnotherTree) {
  Do("key Tab");
  Click("cone, line 18");
  Do("drop " + (project::Root() / "scenes/torus.scn").string());
  EXPECT_FALSE(viewer_->state().selection.node);
  EXPECT_FALSE(HasItem("cone"));
  EXPECT_TRUE(HasItem("torus")) << viewer_->TextOfPanels();
}

}  // namespace
}  // namespace ray
