// Solids made of solids in the languages of YAML and JSON: those of .scn are in tests/R3/Csg.cpp.

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/Project.h"
#include "tests/source/parse/Folder.h"

namespace ray {
namespace {

std::string WithDoubleQuotes(std::string json) {
  std::ranges::replace(json, '\'', '"');
  return json;
}

const std::string look = "'material': {'color': [1, 0, 0], 'kd': 1}",
                  shining = "'materials': [{'kd': [1, 1, 1]}, {'emission': [1, 1, 1]}]";

/// Returns a cube of 2 with a round hole along z in both languages, with `keys` between.
std::string Groningen(const std::string& more,
                      const std::string& hole = "{'type': 'sphere', 'position': [0, 0, 0], 'radius': 1.2, " + look +
                                                "}") {
  return WithDoubleQuotes("{'Eye': [0, 0, 9], 'Objects': [{'type': 'csg', 'operation': 'difference', " + more +
                          "'objects': [{'type': 'box', 'min': [-1, -1, -1], 'max': [1, 1, 1], " + look + "}, " + hole +
                          "]}]}");
}
std::string Cs315(const std::string& more,
                  const std::string& hole = "{'shape': 'Sphere', 'center': [0, 0, 0], 'radius': 1.2, 'material': 0}") {
  return WithDoubleQuotes("{'camera': {'eye': [0, 0, 5], 'at': [0, 0, 0], 'up': [0, 1, 0], 'fovy': 45}, " + shining +
                          ", 'surfaces': [{'shape': 'csg', 'operation': 'difference', 'material': 0, " + more +
                          "'surfaces': [{'shape': 'box', 'min': [-1, -1, -1], 'max': [1, 1, 1], 'material': 0}, " +
                          hole + "]}]}");
}

std::optional<double> Depth(const Scene& scene, double x, double y) {
  const World world(scene);
  Workspace workspace;
  const auto hit = FindAcceleratorKind("bvh")->Make(world, {})->Intersect(R3::Ray{{x, y, 5}, {0, 0, -1}}, workspace);
  return hit ? std::optional(hit->t) : std::nullopt;
}

ParseOptions As(const std::string& format) {
  ParseOptions options;
  options.format = format;
  return options;
}

TEST(CsgOfObjects, CombinesTheSolidsOfItsList) {
  const Folder folder;
  for (const auto& [format, json] : {std::pair{"groningen", Groningen("")}, {"cs315", Cs315("")}}) {
    const Scene scene = Parse(folder.Write("a.json", json), As(format)).scene;
    EXPECT_FALSE(Depth(scene, 0, 0)) << format;
    ASSERT_TRUE(Depth(scene, 0.9, 0.9)) << format;
    EXPECT_NEAR(*Depth(scene, 0.9, 0.9), 4, 1e-12) << format;
  }
}

TEST(CsgOfObjects, IsPlacedAndMovedAsAWhole) {
  const Folder folder;
  const Scene scene =
      Parse(folder.Write("a.json", Cs315("'transforms': [['Translate', [3, 0, 0]]], 'velocity': [0, 1, 0], ")),
            As("cs315"))
          .scene;
  EXPECT_FALSE(Depth(scene, 3, 0));
  EXPECT_NEAR(Depth(scene, 3.9, 0.9).value_or(0), 4, 1e-12);
  EXPECT_FALSE(Depth(scene, 0.9, 0.9));
  EXPECT_TRUE(World(scene).Moves());
}

TEST(CsgOfObjects, InvalidPartsAreErrorsAtTheirPosition) {
  const auto report = [](const std::string& format, const std::string& json) {
    const Folder folder;
    folder.Write("a.json", json);
    return ReportOf(folder, "a.json", As(format));
  };
  EXPECT_TRUE(Contains(
      report("groningen", Groningen("", "{'type': 'plane', 'position': [0, 0, 0], 'normal': [0, 1, 0], " + look + "}")),
      "csg combines closed solids, but this shape is not closed"));
  EXPECT_TRUE(
      Contains(report("cs315", Cs315("", "{'shape': 'Sphere', 'center': [0, 0, 0], 'radius': 1, 'material': 1}")),
               "solids of a csg cannot emit light"));
  EXPECT_TRUE(Contains(
      report("cs315",
             Cs315("", "{'shape': 'Sphere', 'center': [0, 0, 0], 'radius': 1, 'material': 0, 'velocity': [1, 0, 0]}")),
      "solids of a csg cannot move on their own"));
  std::string misspelled = Groningen("");
  misspelled.replace(misspelled.find("difference"), 10, "diference");
  EXPECT_TRUE(Contains(report("groningen", misspelled), "did you mean 'difference'?"));
}

}  // namespace
}  // namespace ray
