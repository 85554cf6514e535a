// Formulas in parentheses stand for numbers.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "R3/ShapeKind.h"
#include "source/parse/scn/ScnText.h"
#include "source/text/NumberText.h"
#include "tests/Draw.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

/// Returns the arguments of the only shape, as read.
std::vector<double> NumbersOf(const std::string& text, const std::vector<std::string>& definitions = {}) {
  const Folder folder;
  ParseOptions options;
  options.definitions = definitions;
  const ParsedScene parsed = Parse(folder.Write("scene.scn", text), options);
  return parsed.scene.root.children.at(0).shape->MadeFrom()->arguments;
}

/// A random formula and its value, computed independently.
struct Formula {
  std::string text;
  double value;
};

Formula RandomFormula(Draw& draw, int depth, double variable) {
  const auto inner = [&] { return RandomFormula(draw, depth - 1, variable); };
  if (depth == 0 || draw.Whole(0, 5) == 0) {
    if (draw.Whole(0, 2) == 0) return {"$v", variable};
    const double number = draw.Between(0, 9);
    return {ToText(number), number};
  }
  const Formula a = inner(), b = inner();
  switch (draw.Whole(0, 7)) {
    case 0:
      return {"(" + a.text + "+" + b.text + ")", a.value + b.value};
    case 1:
      return {"( " + a.text + " - " + b.text + " )", a.value - b.value};
    case 2:
      return {"(" + a.text + ")*(" + b.text + ")", a.value * b.value};
    case 3:
      return {"((" + a.text + ")/(" + b.text + "+ 0.5))", a.value / (b.value + 0.5)};
    case 4:
      return {"sqrt(abs(" + a.text + "))", std::sqrt(std::abs(a.value))};
    case 5:
      return {"max(" + a.text + ", " + b.text + ")", std::max(a.value, b.value)};
    case 6:
      return {"(- (" + a.text + "))", -a.value};
    default:
      return {"(" + a.text + ")^2", a.value * a.value};
  }
}

TEST(Arithmetic, RandomFormulasHaveTheirValues) {
  int finite = 0;
  for (int i = 0; i < 300; ++i) {
    Draw draw(static_cast<std::uint64_t>(i) + 90);
    const double variable = draw.Between(-3, 3);
    const Formula formula = RandomFormula(draw, 5, variable);
    if (!(std::abs(formula.value) < 1e100)) continue;
    ++finite;
    EXPECT_EQ(NumbersOf("sphere -1 (" + formula.text + ") 0 0 1", {"v=" + ToText(variable)})[0], formula.value)
        << formula.text;
  }
  EXPECT_GT(finite, 250);
}

TEST(Arithmetic, StandsWhereverANumberStands) {
  const Scene scene =
      ParseText(
          "define day 30\ndefine turn ($day * 12 + 30)\nset samples (2 ^ 4)\nset max_depth ($day/10)\n"
          "camera 0 0 (3 * 3)  0 0 -1  0 1 0  (pi / 8) .01 100\n"
          "material (1/4) 0 0  0 0 0  0 0 0  0 0 0  0 0 0  (10+10) 1 0\n"
          "point_light 1 1 1  0 (sqrt(16)) 0  1 0 0\n"
          "begin (1-1) rotate $turn 0 1 0 translate 0 ( 1 + 1 ) 0\nsphere (0) (min(2, 3)) 0 0 (1/3)# a comment\n"
          "end\n")
          .scene;
  EXPECT_EQ(scene.settings.at(0).value, "16");
  EXPECT_EQ(scene.settings.at(1).value, "3");
  EXPECT_EQ(scene.camera.eye.z, 9);
  EXPECT_EQ(scene.materials.at(1).ka.r, 0.25);
  EXPECT_EQ(scene.materials.at(1).n, 20);
  const Node& group = scene.root.children.at(0);
  EXPECT_EQ(group.material, 1);
  EXPECT_NEAR(group.transform.m[0][0], std::cos(390 * std::numbers::pi / 180), 1e-15);
  EXPECT_EQ(group.children.at(0).shape->MadeFrom()->arguments, (std::vector<double>{2, 0, 0, 1 / 3.0}));
}

TEST(Arithmetic, TheCommandLineMayDefineAFormula) {
  EXPECT_EQ(NumbersOf("define d 1\nsphere -1 0 0 0 ($r / 2)\n", {"r=8"})[3], 4);
  EXPECT_EQ(NumbersOf("sphere -1 0 0 0 $r\n", {"r=(1 + 1/4)"})[3], 1.25);
  ParseOptions options;
  options.definitions = {"r=(1 + )"};
  const Folder folder;
  folder.Write("a.scn", "sphere -1 0 0 0 $r\n");
  EXPECT_TRUE(Contains(ReportOf(folder, "a.scn", options), "a.scn:1:17: error: $r stands for (1 + ): "));
}

TEST(Arithmetic, AConvertedSceneHasTheNumbers) {
  const Folder folder;
  const std::string text =
      "define r (2/3)\nmaterial ($r) 0 0  0 0 0  0 0 0  0 0 0  0 0 0  1 1 0\nsphere 0 (-$r) (sin(1)) 0 "
      "($r $r)\n";
  const ParsedScene once = Parse(folder.Write("a.scn", text), {});
  const std::string converted = WriteScn(once.scene, folder / "b.scn").text;
  const ParsedScene again = Parse(folder.Write("b.scn", converted), {});
  EXPECT_EQ(WriteScn(again.scene, folder / "b.scn").text, converted);
  EXPECT_EQ(again.scene.root.children.at(0).shape->MadeFrom()->arguments,
            once.scene.root.children.at(0).shape->MadeFrom()->arguments);
  EXPECT_FALSE(Contains(converted, "sin"));
}

TEST(Arithmetic, NamesOfFilesMayBeginWithAParenthesis) {
  const Folder folder;
  folder.Write("(1)one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.Write("(2)", "sphere -1 0 0 0 1\n");
  EXPECT_EQ(Parse(folder.Write("a.scn", "mesh -1 (1)one.obj\n"), {}).scene.root.children.size(), 1u);
  EXPECT_EQ(Parse(folder.Write("b.scn", "include \"(2)\"\n"), {}).scene.root.children.size(), 1u);
}

TEST(Arithmetic, WithoutParenthesesAHintShowsThem) {
  for (const std::string word : {"1/2", "2*3", "pi/4", "-2^2", "sqrt(2)", "$r+1"}) {
    const std::string report = ReportOf("define r 3\nsphere -1 0 0 0 " + word + "\n");
    EXPECT_TRUE(Contains(report, "arithmetic needs parentheses: (" + word + ")")) << report;
    EXPECT_NO_THROW(ParseText("define r 3\nsphere -1 0 0 (" + word + ") 1\n")) << word;
  }
  for (const std::string word : {"1/0x", "abc/2", "1-2-", "a.obj"})
    EXPECT_FALSE(Contains(ReportOf("sphere -1 0 0 0 " + word + "\n"), "parentheses")) << word;
}

}  // namespace
}  // namespace ray
