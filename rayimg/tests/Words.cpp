// rayimg's tables, which help, manual, completions and docs/options.md repeat.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "source/app/manual/Manual.h"
#include "source/app/options/OptionTable.h"
#include "rayimg/tests/Rayimg.h"

namespace ray::rayimg {
namespace {

TEST(Rayimg, HelpIsAnsweredAnywhere) {
  NEEDS_RAYIMG();
  for (const CommandKind& command : program.commands()) {
    const Finished done = Rayimg({command.name, "no.png", "-nonsense", "-help"});
    EXPECT_EQ(done.status, 0);
    EXPECT_EQ(done.output, Help(program, command.name));
    EXPECT_EQ(Rayimg({"-help", command.name}).output, Help(program, command.name));
  }
  EXPECT_EQ(Rayimg({"--help"}).output, Help(program, ""));
  EXPECT_EQ(Rayimg({"-version"}).output, Version(program));
  EXPECT_EQ(Rayimg({"-man"}).output, ManualPage(program));
  EXPECT_EQ(Rayimg({"-complete", "bash"}).output, BashCompletion(program));
}

TEST(RayimgHelp, NamesEveryOptionAtItsCommandAndFitsTheScreen) {
  for (const CommandKind& command : program.commands()) {
    EXPECT_TRUE(Has(Help(program, ""), "\n  " + std::string(command.name) + " ")) << command.name;
    const std::string help = Help(program, command.name);
    for (const OptionKind& option : OptionTable(program))
      EXPECT_EQ(Has(help, "\n  " + Synopsis(option)), Takes(command, option)) << command.name << " " << option.name;
    std::istringstream lines(help + Help(program, ""));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 120u) << line;
  }
}

TEST(RayimgHelp, EveryOptionBelongsToACommandThatExists) {
  for (const OptionKind& option : OptionTable(program)) {
    EXPECT_EQ(option.commands.empty(), !IsSetting(option)) << option.name;
    for (const char* command : option.commands)
      EXPECT_TRUE(FindCommand(program, command)) << option.name << " " << command;
  }
}

TEST(RayimgHelp, CompletionAndManualListEveryOption) {
  for (const OptionKind& option : OptionTable(program)) {
    const std::string name = option.name;
    EXPECT_TRUE(Has(BashCompletion(program), "-" + name)) << name;
    EXPECT_TRUE(Has(ManualPage(program), ".B \\-" + name)) << name;
  }
}

/// Returns the completions that bash offers for the last word.
std::string BashOffers(const std::string& words) {
  const TemporaryFolder folder;
  WriteFile(folder / "complete", BashCompletion(program));
  const std::string command = "bash -c '. " + folder / "complete" + "; COMP_WORDS=(" + words +
                              "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _rayimg; echo \"${COMPREPLY[@]}\"'";
  FILE* pipe = popen(command.c_str(), "r");
  char line[4096] = "";
  if (pipe && !std::fgets(line, sizeof line, pipe)) line[0] = 0;
  if (pipe) pclose(pipe);
  return line;
}

TEST(RayimgHelp, BashOffersCommandsTheirOptionsAndChoices) {
  if (std::system("command -v bash >/dev/null 2>&1") != 0) GTEST_SKIP() << "bash is not installed";
  EXPECT_EQ(BashOffers("rayimg conv"), "convert\n");
  EXPECT_EQ(BashOffers("rayimg diff a.png -refer"), "-reference2\n");
  EXPECT_EQ(BashOffers("rayimg info -refer"), "\n");
  EXPECT_EQ(BashOffers("rayimg convert a b -tonemap f"), "filmic\n");
  EXPECT_EQ(BashOffers("rayimg -complete b"), "bash\n");
}

// The documentation must list every option and no removed one.
TEST(RayimgHelp, TheDocumentedTableIsCurrent) {
  const char* root = std::getenv("RAYPRO_ROOT");
  const std::string page = ReadFile(std::string(root ? root : ".") + "/docs/options.md");
  EXPECT_TRUE(Has(page, Help(program, "markdown"))) << "run script/update_docs.sh";
}

}  // namespace
}  // namespace ray::rayimg
