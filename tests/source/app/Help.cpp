#include "source/app/Help.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "source/app/Completion.h"
#include "source/app/Listing.h"
#include "source/app/Manual.h"
#include "source/app/OptionTable.h"
#include "tests/source/app/Program.h"

namespace ray {
namespace {

bool Contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

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

TEST(Help, NamesEveryOptionOnceWithItsDefaultAndFitsTheScreen) {
  const std::string help = Help("");
  for (const OptionKind& option : OptionTable()) {
    EXPECT_EQ(Count(help, "\n  " + Synopsis(option) + (Synopsis(option).size() < 23 ? " " : "\n")), 1u) << option.name;
    const std::string value = Show(option, Options{});
    EXPECT_TRUE(value.empty() || Contains(Help(option.name), "default " + value + ")")) << option.name;
  }
  for (const std::string& line : Lines(help)) EXPECT_LE(line.size(), 120u) << line;
}

TEST(Help, ATopicHoldsItsOptionsAndNoOthers) {
  for (const std::string& topic : OptionTopics())
    for (const OptionKind& option : OptionTable())
      EXPECT_EQ(Contains(Help(topic), "\n  " + Synopsis(option) + (Synopsis(option).size() < 23 ? " " : "\n")),
                topic == option.topic)
          << topic << " " << option.name;
}

TEST(Help, TopicsAreTogetherInTheTable) {
  std::vector<std::string> topics = OptionTopics();
  std::ranges::sort(topics);
  EXPECT_EQ(std::ranges::adjacent_find(topics), topics.end());
}

TEST(Help, ShowsNoAlias) {
  for (const OptionKind& option : OptionTable())
    for (const char* alias : option.aliases) EXPECT_FALSE(Contains(Help(""), "-" + std::string(alias) + " ")) << alias;
}

TEST(Help, TheMarkdownTableHasARowForEveryOptionWithFourCells) {
  const auto lines = Lines(Help("markdown"));
  ASSERT_EQ(lines.size(), OptionTable().size() + 2);
  for (const std::string& line : lines) EXPECT_EQ(Count(line, "|") - Count(line, "\\|"), 5u) << line;
}

// A reader of the README must not meet an option that is gone, or miss one.
TEST(Help, TheReadmesOptionTableIsOurs) {
  const char* root = std::getenv("RAYPRO_ROOT");
  const std::string readme = ray::testing::ReadFile(std::string(root ? root : ".") + "/README.md");
  if (!Contains(readme, "| option | default |")) GTEST_SKIP() << "README.md has no option table yet";
  EXPECT_TRUE(Contains(readme, Help("markdown"))) << "replace the table by what raypro -help markdown prints";
}

TEST(Manual, NamesEveryOptionAndNoLineStartsWithAStrayDot) {
  const std::string page = ManualPage();
  for (const OptionKind& option : OptionTable())
    EXPECT_EQ(Count(page, ".B " + WithRoffDashes(Synopsis(option)) + "\n"), 1u) << option.name;
  for (const std::string& line : Lines(page)) {
    if (!line.starts_with('.')) continue;
    const std::string macro = line.substr(0, line.find(' '));
    EXPECT_TRUE(Contains(" .TH .SH .SS .TP .B .I .RI .nf .fi ", " " + macro + " ")) << line;
  }
}

TEST(Completion, EveryShellLearnsEveryOption) {
  std::string bash_words = CompletionScript("bash");
  std::ranges::replace(bash_words, '\'', ' ');
  for (const OptionKind& option : OptionTable()) {
    const std::string name = option.name;
    EXPECT_TRUE(Contains(bash_words, " -" + name + " ")) << name;
    EXPECT_TRUE(Contains(CompletionScript("zsh"), "-" + name + "[")) << name;
    EXPECT_TRUE(Contains(CompletionScript("fish"), " -o " + name + " ")) << name;
  }
}

/// What bash offers for the last of the words.
std::string BashOffers(const std::string& words) {
  const ray::testing::TemporaryFolder folder;
  ray::testing::WriteFile(folder / "complete", CompletionScript("bash"));
  const std::string command = "bash -c '. " + folder / "complete" + "; COMP_WORDS=(" + words +
                              "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _raypro; echo \"${COMPREPLY[@]}\"'";
  FILE* pipe = popen(command.c_str(), "r");
  char line[4096] = "";
  if (pipe && !std::fgets(line, sizeof line, pipe)) line[0] = 0;
  if (pipe) pclose(pipe);
  return line;
}

TEST(Completion, BashFindsOptionsAndTheirChoices) {
  if (std::system("command -v bash >/dev/null 2>&1") != 0) GTEST_SKIP() << "bash is not installed";
  EXPECT_EQ(BashOffers("raypro -wid"), "-width\n");
  EXPECT_EQ(BashOffers("raypro in.scn out.jpg -shadows o"), "on off\n");
  EXPECT_EQ(BashOffers("raypro -complete z"), "zsh\n");
}

TEST(Listing, EverySubjectListsSomethingAndAllTogetherListEverything) {
  for (const std::string& subject : ListSubjects()) {
    const std::string list = Listing(subject);
    EXPECT_TRUE(list.starts_with(subject + ":\n  ")) << list;
    EXPECT_TRUE(Contains(Listing(""), list)) << subject;
  }
  EXPECT_TRUE(Contains(Listing("shapes"), "\n  sphere "));
  EXPECT_TRUE(Contains(Listing("accelerators"), "\n  none "));
  EXPECT_TRUE(Contains(Listing("scenes"), ".scn"));
}

TEST(Version, NamesTheProgramAndItsFeatures) {
  EXPECT_TRUE(Version().starts_with("raypro "));
  EXPECT_TRUE(Contains(Version(), "jpeg="));
}

}  // namespace
}  // namespace ray
