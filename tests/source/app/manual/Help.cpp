#include "source/app/manual/Manual.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "source/app/options/OptionTable.h"
#include "source/parse/Parse.h"
#include "source/parse/scn/Command.h"
#include "tests/source/app/Program.h"
#include "tests/source/app/options/ScenePrograms.h"

namespace ray {
namespace {

using testing::Has;

std::size_t Count(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

std::vector<std::string> Lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The manual page writes every dash with a backslash.
std::string WithRoffDashes(const std::string& text) {
  std::string roff;
  for (const char c : text) roff += c == '-' ? "\\-" : std::string(1, c);
  return roff;
}

/// Returns the beginning of the help lines of an option.
std::string Entry(const OptionKind& option) {
  return "\n  " + Synopsis(option) + (Synopsis(option).size() < 23 ? " " : "\n");
}

TEST(Help, NamesEveryOptionAndItsDefaultAndFitsTheScreen) {
  for (const Program& program : scene_programs) {
    const std::string help = Help(program, "");
    for (const OptionKind& option : OptionTable(program)) {
      EXPECT_EQ(Count(help, Entry(option)), 1u) << option.name;
      const std::string value = program.defaults()->Show(option);
      EXPECT_TRUE(value.empty() || Has(Help(program, option.name), "default " + value + ")")) << option.name;
    }
    for (const std::string& line : Lines(help)) EXPECT_LE(line.size(), 120u) << line;
  }
}

// Every text that a program prints about itself names its own options only.
TEST(Help, NoTextNamesOptionsOfTheOtherProgram) {
  for (const Program& program : scene_programs)
    for (const OptionKind& option : OptionTable(TheOther(program))) {
      if (FindOption(program, option.name)) continue;
      const std::string name = option.name;
      EXPECT_FALSE(Has(Help(program, ""), Entry(option))) << name;
      EXPECT_FALSE(Has(Help(program, "markdown"), "`-" + name)) << name;
      EXPECT_FALSE(Has(ManualPage(program), ".B " + WithRoffDashes(Synopsis(option)) + "\n")) << name;
      EXPECT_FALSE(Has(BashCompletion(program), "-" + name + " ")) << name;
    }
}

TEST(Help, ATopicContainsItsOptionsAndNoOthers) {
  for (const Program& program : scene_programs)
    for (const std::string& topic : OptionTopics(program))
      for (const OptionKind& option : OptionTable(program))
        EXPECT_EQ(Has(Help(program, topic), Entry(option)), topic == option.topic) << topic << " " << option.name;
}

TEST(Help, TopicsAreTogetherInTheTable) {
  for (const Program& program : scene_programs) {
    std::vector<std::string> topics = OptionTopics(program);
    std::ranges::sort(topics);
    EXPECT_EQ(std::ranges::adjacent_find(topics), topics.end());
  }
}

TEST(Help, ShowsNoAlias) {
  for (const Program& program : scene_programs)
    for (const OptionKind& option : OptionTable(program))
      for (const char* alias : option.aliases)
        EXPECT_FALSE(Has(Help(program, ""), "-" + std::string(alias) + " ")) << alias;
}

TEST(Help, EveryOptionHasAMarkdownRowOfFourCells) {
  auto lines = Lines(Help(Program::raypro, "markdown"));
  lines.erase(std::ranges::find(lines, ""), lines.end());  // other lines follow the table
  ASSERT_EQ(lines.size(), OptionTable(Program::raypro).size() + 2);
  for (const std::string& line : lines) EXPECT_EQ(Count(line, "|") - Count(line, "\\|"), 5u) << line;
}

TEST(Help, RayviewsMarkdownHasRowsForItsOwnOptionsAlone) {
  const std::string text = Help(Program::rayview, "markdown");
  for (const OptionKind& option : OptionTable(Program::rayview)) {
    const bool is_shared = option.known_to != KnownTo::rayview;
    EXPECT_EQ(Has(text, "\n| `" + Synopsis(option) + "` |"), !is_shared) << option.name;
    const std::string name = " `-" + std::string(option.name) + "`";
    EXPECT_EQ(Has(text, name + ",") || Has(text, name + "\n"), is_shared) << option.name;
  }
}

// The documentation must list every option and no removed one.
TEST(Help, TheDocumentedOptionTableIsCurrent) {
  const char* root = std::getenv("RAYPRO_ROOT");
  const std::string page = testing::ReadFile(std::string(root ? root : ".") + "/docs/options.md");
  for (const Program& program : scene_programs)
    EXPECT_TRUE(Has(page, Help(program, "markdown"))) << "script/update_docs.sh brings it up to date";
}

TEST(Manual, NamesEveryOptionAndHasNoStrayDots) {
  for (const Program& program : scene_programs) {
    const std::string page = ManualPage(program);
    EXPECT_TRUE(Has(page, ".SH NAME\n" + NameOf(program) + " \\- "));
    for (const OptionKind& option : OptionTable(program))
      EXPECT_EQ(Count(page, ".B " + WithRoffDashes(Synopsis(option)) + "\n"), 1u) << option.name;
    for (const std::string& line : Lines(page)) {
      if (!line.starts_with('.')) continue;
      const std::string macro = line.substr(0, line.find(' '));
      EXPECT_TRUE(Has(" .TH .SH .SS .TP .B .I .BR .RI .nf .fi ", " " + macro + " ")) << line;
    }
  }
}

// Nobody finds a command that the manual does not list.
TEST(Manual, OfScenesHasEveryCommandOfTheLanguage) {
  const std::string page = ManualPage("scn", Program::raypro);
  for (const Command& command : Commands()) {
    EXPECT_EQ(Count(page, "\n.B " + WithRoffDashes(command.usage) + "\n"), 1u) << command.name;
    EXPECT_FALSE(command.about.empty()) << command.name;
  }
  const std::vector<std::string> listed = Lines(Listing(Program::raypro, "commands"));
  EXPECT_EQ(listed.size(), Commands().size() + 1);  // and a heading
  for (std::size_t i = 1; i < listed.size(); ++i)
    EXPECT_TRUE(Has(page, "\n.B " + WithRoffDashes(listed[i].substr(2)) + "\n")) << listed[i];
}

TEST(Manual, OfScenesShowsAValidExample) {
  const std::string page = ManualPage("scn", Program::raypro), heading = ".SH EXAMPLE\n.nf\n";
  ASSERT_TRUE(Has(page, heading));
  const std::size_t start = page.find(heading) + heading.size();
  std::string scene = page.substr(start, page.find(".fi\n", start) - start);
  std::erase(scene, '\\');
  const ray::testing::TemporaryFolder folder;
  ray::testing::WriteFile(folder / "example.scn", scene);
  const ParsedScene parsed = Parse(folder / "example.scn", {});
  EXPECT_TRUE(parsed.warnings.empty());
  EXPECT_EQ(parsed.scene.lights.size(), 1u);
}

TEST(Manual, FormatsWithoutMessagesFromRoff) {
  if (std::system("command -v groff >/dev/null 2>&1") != 0) GTEST_SKIP() << "groff is not installed";
  const ray::testing::TemporaryFolder folder;
  for (const Program& program : scene_programs)
    for (const std::string& name : {std::string(), std::string("scn")}) {
      ray::testing::WriteFile(folder / "page", ManualPage(name, program));
      std::system(("groff -man -Tutf8 -ww '" + folder / "page" + "' 2>'" + folder / "words" + "' >/dev/null").c_str());
      EXPECT_EQ(testing::ReadFile(folder / "words"), "") << NameOf(program) << name;
    }
}

TEST(BashCompletion, OffersEveryOption) {
  for (const Program& program : scene_programs) {
    std::string bash_words = BashCompletion(program);
    std::ranges::replace(bash_words, '\'', ' ');
    for (const OptionKind& option : OptionTable(program)) {
      const std::string name = option.name;
      EXPECT_TRUE(Has(bash_words, " -" + name + " ")) << name;
    }
  }
}

TEST(Listing, EverySubjectListsSomethingAndAllTogetherListEverything) {
  for (const Program& program : scene_programs) {
    for (const std::string& subject : ListSubjects(program)) {
      const std::string list = Listing(program, subject, {"H  this help"});
      EXPECT_TRUE(list.starts_with(subject + ":\n  ")) << list;
      EXPECT_TRUE(Has(Listing(program, "", {"H  this help"}), list)) << subject;
    }
    EXPECT_TRUE(Has(Listing(program, "shapes"), "\n  sphere "));
    EXPECT_TRUE(Has(Listing(program, "accelerators"), "\n  none "));
    EXPECT_TRUE(Has(Listing(program, "scenes"), ".scn"));
  }
  EXPECT_FALSE(Has(Listing(Program::rayview, ""), "presets"));
}

TEST(Version, NamesTheProgramAndItsFeatures) {
  for (const Program& program : scene_programs) {
    EXPECT_TRUE(Version(program).starts_with(NameOf(program) + " "));
    EXPECT_TRUE(Has(Version(program), "\nbuilt with: jpeg="));
  }
}

}  // namespace
}  // namespace ray
