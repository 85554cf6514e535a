#include "tests/source/view/Contrast.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "R2/ImageFile.h"
#include "source/integrate/debug/Heat.h"
#include "source/inspect/DebugRays.h"
#include "source/view/panels/PanelLook.h"
#include "tests/source/view/ScriptedViewer.h"
#include "tests/source/view/WithOptions.h"

namespace ray {
namespace {

using Corner = PanelDrawing::Corner;

constexpr contrast::Color black{0, 0, 0}, white{1, 1, 1};
constexpr double most_contrast = 21;  // of black and white

struct Triangle {
  Corner corners[3];
  PanelDrawing::Part part;

  /// What is filled has one place on the sheet, letters have several.
  bool IsLetter() const {
    const auto differs = [&](const Corner& c) { return c.u != corners[0].u || c.v != corners[0].v; };
    return differs(corners[1]) || differs(corners[2]);
  }
  Corner Middle() const {
    return {(corners[0].x + corners[1].x + corners[2].x) / 3, (corners[0].y + corners[1].y + corners[2].y) / 3, 0, 0,
            corners[0].color};
  }
  /// Partly above or below of what is seen of a list.
  bool IsScrolledOff() const {
    return std::ranges::any_of(corners, [&](const Corner& c) {
      return c.y < static_cast<float>(part.top) || c.y > static_cast<float>(part.bottom);
    });
  }
  bool Covers(const Corner& p) const {
    if (p.x < static_cast<float>(part.left) || p.x > static_cast<float>(part.right) ||
        p.y < static_cast<float>(part.top) || p.y > static_cast<float>(part.bottom))
      return false;
    const auto side = [&](const Corner& a, const Corner& b) {
      return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    };
    const float s[] = {side(corners[0], corners[1]), side(corners[1], corners[2]), side(corners[2], corners[0])};
    return std::ranges::all_of(s, [](float x) { return x >= 0; }) ||
           std::ranges::all_of(s, [](float x) { return x <= 0; });
  }
};

std::vector<Triangle> TrianglesOf(const PanelDrawing& drawing) {
  std::vector<Triangle> triangles;
  for (const PanelDrawing::Part& part : drawing.parts)
    for (std::size_t i = part.first; i < part.first + part.count; i += 3) {
      const auto at = [&](std::size_t k) { return drawing.corners[drawing.indices[i + k]]; };
      triangles.push_back({{at(0), at(1), at(2)}, part});
    }
  return triangles;
}

/// The least contrast of letters that are seen, over whatever the image has there.
double LeastContrast(const PanelDrawing& drawing) {
  std::vector<Triangle> filled;
  double least = most_contrast;
  for (const Triangle& triangle : TrianglesOf(drawing)) {
    if (!triangle.IsLetter()) {
      filled.push_back(triangle);
      continue;
    }
    const Corner middle = triangle.Middle();
    if (!triangle.Covers(middle) || triangle.IsScrolledOff()) continue;
    for (const contrast::Color& behind : {black, white}) {
      contrast::Color ground = behind;
      for (const Triangle& below : filled)
        if (below.Covers(middle))
          ground = contrast::Over(contrast::AsColor(below.corners[0].color), below.corners[0].color[3] / 255.0, ground);
      const auto ink = contrast::Over(contrast::AsColor(middle.color), middle.color[3] / 255.0, ground);
      least = std::min(least, contrast::Between(ink, ground));
    }
  }
  return least;
}

/// The least contrast of lines of the cross section, had they their full strength.
double LeastContrastOfSection(const FrameState& shown) {
  const R2::Color& c = shown.section_ground;
  double least = most_contrast;
  for (const Vertex& vertex : *shown.section)
    least = std::min(least, contrast::Between(contrast::AsColor(vertex.color), {c.r, c.g, c.b}));
  return least;
}

class PanelContrast : public ScriptedViewer<WithOptions, 512, 512> {
 protected:
  void Click(const std::string& start) {
    viewer_->Show();
    if (!viewer_->state().shows.help) viewer_->Reveal(start);
    const auto& items = viewer_->ItemsOfPanels();
    const auto item = std::ranges::find_if(items, [&](const PanelItem& i) { return i.name.starts_with(start); });
    ASSERT_TRUE(item != items.end()) << start;
    const std::string at = std::to_string(item->x) + " " + std::to_string(item->y);
    Do("move " + at);
    ExpectReadable(start + ", under the pointer");
    Do("down left " + at);
    ExpectReadable(start + ", pressed");
    Do("up left " + at);
    ExpectReadable(start + ", clicked");
  }
  void ExpectSectionSeen() {
    const FrameState shown = viewer_->Show();
    ASSERT_TRUE(shown.section);
    EXPECT_GT(shown.section->size(), 1000u);
    EXPECT_GE(LeastContrastOfSection(shown), contrast::of_marks);
  }
  void ExpectReadable(const std::string& where) {
    const auto panels = viewer_->Show().panels;
    ASSERT_TRUE(panels);
    const double least = LeastContrast(*panels);
    EXPECT_LT(least, most_contrast) << "no letter is seen: " << where;
    EXPECT_GE(least, contrast::of_text) << where;
  }
};

TEST_F(PanelContrast, LettersAreReadableInBothThemesOverAnything) {
  for (const char* theme : {"dark", "light"}) {
    SCOPED_TRACE(theme);
    Open(project::Root() / "scenes/hello.scn");
    viewer_->ShowPanels({theme == std::string("dark") ? PanelTheme::dark : PanelTheme::light});
    for (const char* item : {"cone, line 18", "deselect", "Scene"}) Click(item);
    Do("click right 100 250");
    for (const char* item : {"camera ", "to lights", "Pixel", "Render", "light", "-mode", "path", "-samples"})
      Click(item);
    Do("key Escape");
    for (const char* item :
         {"Render", "View", "faces", "boxes of the scene graph", "slide level", "cut along xz", "no cut",
          "slide view angle", "larger", "smaller", "View", "Image", "live", "depth"})
      Click(item);
    Do("wait trace");
    for (const char* item :
         {"slide exposure", "Image", "Render", "compare all", "Render", "Scene", "Lights", "point_light", "pick color"})
      Click(item);
    Do("key H");
    Click("search");
  }
}

/// Black and near white are the grounds of labels, whatever their opacity.
int GroundsOf(const PanelDrawing& drawing, int gray) {
  int count = 0;
  for (const Triangle& t : TrianglesOf(drawing)) {
    const Rgba& c = t.corners[0].color;
    count += !t.IsLetter() && c[0] == gray && c[1] == gray && c[2] == gray && c[3] > 0 && c[3] < 255;
  }
  return count;
}

TEST_F(PanelContrast, LabelsOverTheViewFollowTheThemeAndAreReadable) {
  for (const PanelTheme theme : {PanelTheme::dark, PanelTheme::light}) {
    SCOPED_TRACE(theme == PanelTheme::dark ? "dark" : "light");
    const int own = theme == PanelTheme::dark ? 0 : Label::light_ground;
    const int other = theme == PanelTheme::dark ? Label::light_ground : 0;
    Open(project::Root() / "scenes/hello.scn");
    viewer_->ShowPanels({theme});
    Do("key Tab");
    Do("click left 250 250");
    ExpectReadable("what was picked");
    Do("key Escape");
    Do("key S");
    Do("wait trace");
    Do("key I");
    Do("scroll 40 250 250");
    ExpectReadable("values of pixels");
    EXPECT_GT(GroundsOf(*viewer_->Show().panels, own), 6) << "no values of a pixel are seen";
    EXPECT_EQ(GroundsOf(*viewer_->Show().panels, other), 0);
    Do("key R");
    Do("key Shift+D");
    ExpectReadable("the scale of differences");
    Do("key Escape");
    Do("key X");
    ExpectReadable("axes of the cross section");
    EXPECT_EQ(GroundsOf(*viewer_->Show().panels, other), 0);
    ExpectSectionSeen();
  }
}

TEST_F(PanelContrast, MistakesOfASceneAreReadInBothThemes) {
  const CopiedScenes copies;
  for (const PanelTheme theme : {PanelTheme::dark, PanelTheme::light}) {
    std::filesystem::copy_file(copies / "glass.scn", copies / "edited.scn",
                               std::filesystem::copy_options::overwrite_existing);
    Open(copies / "edited.scn");
    viewer_->ShowPanels({theme});
    std::ofstream(copies / "edited.scn") << "spere -1  0 0 0  1\n";
    Do("key Control+R");
    ASSERT_FALSE(viewer_->state().scene.Mistakes().empty());
    ExpectReadable("errors");
  }
}

/// Letters beyond the left and right edges of what they are drawn in.
int LettersCutOff(const PanelDrawing& drawing) {
  int count = 0;
  for (const Triangle& t : TrianglesOf(drawing)) {
    if (!t.IsLetter()) continue;
    for (const Corner& c : t.corners)
      count += c.x > static_cast<float>(t.part.right) || c.x < static_cast<float>(t.part.left);
  }
  return count;
}

TEST_F(PanelContrast, NoPanelLineIsCutOffAtAnyWindowSize) {
  for (const char* size : {"512 512", "1280 800", "3840 2160 2"}) {
    SCOPED_TRACE(size);
    Open(project::Root() / "scenes/hello.scn");
    Do(std::string("resize ") + size);
    viewer_->ShowPanels({});
    const auto expect_whole = [&](const char* where) {
      EXPECT_EQ(LettersCutOff(*viewer_->Show().panels), 0) << where << "\n" << viewer_->TextOfPanels();
    };
    expect_whole("as they open");
    Do("click right 100 250");
    for (const char* item :
         {"cone, line 18", "Scene", "camera ", "Pixel", "Render", "light", "Render", "Image", "live", "heat", "Image",
          "View", "boxes of the accelerator", "View", "Scene"}) {
      Click(item);
      expect_whole(item);
    }
    Do("key H");
    expect_whole("help");
  }
}

TEST(PanelMarks, FramesAndTicksStandOutInBothThemes) {
  ImGuiContext* const context = ImGui::CreateContext();
  for (const PanelTheme theme : {PanelTheme::dark, PanelTheme::light}) {
    UseLook(theme, 1);
    const ImVec4* colors = ImGui::GetStyle().Colors;
    const auto over = [&](ImGuiCol_ color, const contrast::Color& ground) {
      const ImVec4& c = colors[color];
      return contrast::Over({c.x, c.y, c.z}, c.w, ground);
    };
    EXPECT_GE(ImGui::GetStyle().FrameBorderSize, 1);
    for (const contrast::Color& behind : {black, white}) {
      const auto column = over(ImGuiCol_WindowBg, behind), frame = over(ImGuiCol_FrameBg, column);
      EXPECT_GE(contrast::Between(over(ImGuiCol_Border, column), column), contrast::of_marks);
      EXPECT_GE(contrast::Between(over(ImGuiCol_CheckMark, frame), frame), contrast::of_marks);
      EXPECT_GE(contrast::Between(over(ImGuiCol_SliderGrab, frame), frame), contrast::of_marks);
      const auto track = over(ImGuiCol_ScrollbarBg, column);
      for (const ImGuiCol_ grab : {ImGuiCol_ScrollbarGrab, ImGuiCol_ScrollbarGrabHovered, ImGuiCol_ScrollbarGrabActive})
        EXPECT_GE(contrast::Between(over(grab, track), track), contrast::of_marks) << grab;
    }
  }
  ImGui::DestroyContext(context);
}

TEST(PanelMarks, RayLegendColorsAreVisibleOnBlackAndDistinct) {
  std::vector<Rgba> all{ColorOfNormals()};
  for (std::size_t kind = 0; kind < shown_ray_kinds; ++kind)
    for (const Rgba& color : ColorsOf(static_cast<ShownRays>(kind))) all.push_back(color);
  EXPECT_EQ(all.size(), 7u) << "five kinds, blocked ones, and normals";
  for (const Rgba& color : all) {
    EXPECT_GE(contrast::Between(contrast::AsColor(color), black), contrast::of_marks);
    EXPECT_EQ(std::ranges::count(all, color), 1);
  }
}

TEST(PanelMarks, EndsOfTheBarOfCostsAreToldApart) {
  const auto at = [](double cost) {
    const R2::Color c = HeatColor(cost);
    return contrast::Color{c.r, c.g, c.b};
  };
  EXPECT_GE(contrast::Between(at(1), at(10000)), contrast::of_text);
  EXPECT_GE(contrast::Between(at(100), at(10000)), contrast::of_marks);
}

}  // namespace
}  // namespace ray
