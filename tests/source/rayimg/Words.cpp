// What rayimg says of wrong input; and its tables, which help, manual, completions and docs/options.md repeat.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "source/app/manual/Completion.h"
#include "source/app/manual/Help.h"
#include "source/app/manual/Manual.h"
#include "source/app/options/OptionTable.h"
#include "tests/source/rayimg/Rayimg.h"

namespace ray::rayimg {
namespace {

TEST(Rayimg, WrongInputGivesAnErrorLineAndNoOutput) {
  NEEDS_RAYIMG();
  const TemporaryFolder folder;
  const std::string a = Save(folder / "a.png", Filled(4, 4, {0.5, 0.5, 0.5}));
  const std::string small = Save(folder / "small.png", Filled(2, 4, {}));
  const std::string light = Save(folder / "light.pfm", Filled(4, 4, {}));
  const std::string text = WriteFile(folder / "text.png", "this is no image\n");
  const std::string empty = WriteFile(folder / "empty.exr", "");
  const std::string cut = WriteFile(folder / "cut.pfm", ReadFile(light).substr(0, 60));
  const std::string huge = WriteFile(folder / "huge.pfm", "PF\n1000000 1000000\n-1\n");
  const std::string frame = Save(folder / "frame.jpg", Filled(4, 4, {0.5, 0.5, 0.5}));
  const std::string wide = Save(folder / "wide.jpg", Filled(6, 4, {0.5, 0.5, 0.5}));
  const std::string avi = folder / "out.avi";
  const std::string out = folder / "out.png", missing = folder / "missing.png";
  const struct {
    Words words;
    int status;
    const char* message;
  } cases[] = {
      {{},
       2,
       "no command is named; it must be diff, info, extract, convert, resize, crop, side-by-side, contact-sheet, merge "
       "or movie"},
      {{"dif", a, a}, 2, "unknown command 'dif'; did you mean 'diff'?"},
      {{"frobnicate"},
       2,
       "it must be diff, info, extract, convert, resize, crop, side-by-side, contact-sheet, merge or movie"},
      {{"-versoin"}, 2, "did you mean '-version'?"},
      {{"-version", a}, 2, "unknown command"},
      {{"-complete"}, 2, "-complete needs a value: -complete shell"},
      {{"-complete", "csh"}, 2, "-complete must be bash"},
      {{"-help", "nothing"},
       2,
       "-help must be diff, info, extract, convert, resize, crop, side-by-side, contact-sheet, merge, movie, about or "
       "markdown"},
      {{"diff"}, 2, "needs 2 file names, got 0 (usage: rayimg diff image reference [options])"},
      {{"diff", a, a, a}, 2, "unexpected extra argument"},
      {{"diff", a, ""}, 2, "a file name is empty"},
      {{"diff", a, a, "-fial", "1"}, 2, "unknown option '-fial'; did you mean '-fail'?"},
      {{"diff", a, a, "-exposure", "1"}, 2, "-exposure is an option of rayimg convert or contact-sheet, not of diff"},
      {{"diff", a, a, "-fail"}, 2, "-fail needs a value: -fail x"},
      {{"diff", a, a, "-fail", "-1"}, 2, "-fail must be a number, at least 0, got '-1'"},
      {{"diff", a, a, "-fail", "nan"}, 2, "got 'nan'"},
      {{"diff", a, a, "-fail_percent", "1"}, 2, "-fail_percent has no effect without -fail"},
      {{"diff", a, a, "-map_of", "display"}, 2, "-map_of has no effect without -map"},
      {{"diff", a, a, "-fail", "0", "-fail_percent", "101"}, 2, "0 to 100"},
      {{"diff", a, a, "-json=yes"}, 2, "'-json' takes no value"},
      {{"diff", a, a, "-map_of", "flop", "-map", out}, 2, "flip or display, got 'flop'; did you mean 'flip'?"},
      {{"diff", a, a, "-map", folder / "out.xyz"}, 2, ".png"},
      {{"diff", a, small}, 2, "images must have one size"},
      {{"diff", a, missing, "-map", out}, 3, "missing.png"},
      {{"diff", a, text}, 3, "text.png: error: unknown image format"},
      {{"diff", a, empty}, 3, "empty.exr: error: the image file is empty"},
      {{"diff", light, cut}, 3, "cut.pfm"},
      {{"diff", light, huge}, 3, "more than the limit"},
      {{"diff", a, folder.Path().string()}, 2, "a.png' is none; diff compares two images or two folders"},
      {{"diff", a, a, "-reference2", missing}, 3, "missing.png"},
      {{"diff", a, a, "-map", a}, 4, "it is the input"},
      {{"diff", a, a, "-map", folder / "none/out.png"}, 4, "does not exist"},
      {{"info"}, 2, "needs 1 file name"},
      {{"info", text}, 3, "text.png"},
      {{"convert", a}, 2, "needs 2 file names, got 1"},
      {{"convert", a, folder / "out"}, 2, "extension"},
      {{"convert", a, out, "-tonemap", "ases"}, 2, "did you mean 'aces'?"},
      {{"convert", a, out, "-exposure", "12abc"}, 2, "-exposure must be a number, -64 to 64, got '12abc'"},
      {{"convert", a, out, "-bits", "12"}, 2, "-bits must be 8 or 16 bits per channel, got '12'"},
      {{"convert", a, folder / "out.jpg", "-bits", "16"}, 2, "-bits 16 needs a PNG"},
      {{"convert", a, out, "-jpeg_quality", "0"}, 2, "a whole number, 1 to 100"},
      {{"convert", text, out}, 3, "text.png"},
      {{"convert", a, a}, 4, "it is the input"},
      {{"diff", a, a, "-html", a}, 4, "it is the input"},
      {{"diff", a, a, "-html", out, "-csv", out}, 2, "-html and -csv cannot both be"},
      {{"diff", folder.Path().string(), a}, 2, "is a folder and"},
      {{"resize", a, out}, 2, "resize needs -width n or -height n"},
      {{"resize", a, out, "-width", "0"}, 2, "-width must be a whole number, 1 to 1000000 pixels, got '0'"},
      {{"resize", a, out, "-width", "1.5"}, 2, "got '1.5'"},
      {{"resize", a, out, "-width", "1000000"}, 2, "are more than the limit of 268435456"},
      {{"resize", a, a, "-width", "2"}, 4, "it is the input"},
      {{"resize", light, out, "-width", "2"},
       2,
       "holds floats, and a png only 0 to 1 in steps; write one of .pfm, .hdr"},
      {{"resize", text, out, "-width", "2"}, 3, "text.png"},
      {{"crop", a, out}, 2, "crop needs -crop x0 y0 x1 y1"},
      {{"crop", a, out, "-crop", "0", "0", "5", "4"}, 2, "0 <= x0 < x1 <= 4 from the left, 0 <= y0 < y1 <= 4"},
      {{"crop", a, out, "-crop", "2", "0", "2", "4"}, 2, "-crop 2 0 2 4 must lie within"},
      {{"crop", light, out, "-crop", "0", "0", "2", "2"}, 2, "holds floats"},
      {{"crop", a, a, "-crop", "0", "0", "2", "2"}, 4, "it is the input"},
      {{"extract", a, "N", folder / "out.pfm"}, 2, "is a png, which has no layers"},
      {{"extract", a, "N"}, 2, "needs 3 file names, got 2"},
      {{"side-by-side", a}, 2, "side-by-side needs -out image"},
      {{"side-by-side", a, wide, "-out", out, "-captions", "one"}, 2, "-captions has 1 text for 2 images"},
      {{"side-by-side", a, "-out", out, "-names", "-captions", "one"}, 2, "contradict each other"},
      {{"side-by-side", light, a, "-out", out}, 2, "holds floats"},
      {{"side-by-side", a, "-out", a}, 4, "it is the input"},
      {{"contact-sheet", a}, 2, "contact-sheet needs -out image"},
      {{"contact-sheet", a, "-out", a}, 4, "it is the input"},
      {{"merge", light, cut}, 2, "needs -out"},
      {{"merge", light, "-out", out}, 2, "needs 2 file names"},
      {{"merge", light, a, "-out", out}, 2, "rounded and clamped; merge takes pfm, hdr and exr"},
      {{"merge", light, light, "-out", out}, 2, "are the same file"},
      {{"merge", light, cut, "-out", out}, 3, "cut.pfm"},
      {{"merge", light, light, "-out", out, "-weights", "1,,2"}, 2, "numbers above 0, separated by commas"},
      {{"merge", light, light, "-out", out, "-weights", "1,0"}, 2, "numbers above 0, separated by commas"},
      {{"merge", light, light, "-out", out, "-weights", "1"}, 2, "-weights has 1 number for 2 images"},
      {{"merge", light, light, "-out", light}, 4, "it is the input"},
      {{"movie"}, 2, "needs 2 file names, got 0 (usage: rayimg movie out.avi frame.jpg... [options])"},
      {{"movie", avi}, 2, "needs 2 file names, got 1"},
      {{"movie", folder / "out.mp4", frame}, 2, "a movie's name ends in .avi, not"},
      {{"movie", frame, frame}, 2, "ends in .avi"},
      {{"movie", avi, frame, a}, 2, "is a png; the frames of a movie are jpeg"},
      {{"movie", avi, frame, wide}, 2, "images must have one size"},
      {{"movie", avi, frame, text}, 3, "text.png: error: unknown image format"},
      {{"movie", avi, frame, missing}, 3, "missing.png"},
      {{"movie", avi, frame, "-fps", "0"}, 2, "-fps must be a number, 0.1 to 1000, got '0'"},
      {{"movie", avi, frame, "-fps", "nan"}, 2, "got 'nan'"},
      {{"movie", folder / "none/out.avi", frame}, 4, "does not exist"},
      {{"movie", folder.Path().string() + "/.avi/", frame}, 2, "ends in .avi"},
  };
  const Words known{"a.png",   "small.png", "light.pfm", "text.png", "empty.exr",
                    "cut.pfm", "huge.pfm",  "frame.jpg", "wide.jpg"};
  for (const auto& [words, status, message] : cases) {
    const Finished done = Rayimg(words);
    EXPECT_EQ(done.status, status) << message << "\n" << done.output << done.error;
    EXPECT_TRUE(Has(done.error, message)) << message << "\n" << done.error;
    EXPECT_EQ(done.output, "") << message;
    EXPECT_EQ(std::ranges::count(done.error, '\n'), 1) << done.error;
    EXPECT_EQ(folder.Others(known), nothing) << message;
  }
}

// --- what it says of itself ---

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

TEST(RayimgHelp, NamesEveryOptionWhereItBelongsAndFitsTheScreen) {
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

TEST(RayimgHelp, TheShellAndTheManualLearnEveryOption) {
  for (const OptionKind& option : OptionTable(program)) {
    const std::string name = option.name;
    EXPECT_TRUE(Has(BashCompletion(program), "-" + name)) << name;
    EXPECT_TRUE(Has(ManualPage(program), ".B \\-" + name)) << name;
  }
}

/// What bash offers for the last of the words.
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

// A reader of the documentation must not meet an option that is gone, or miss one.
TEST(RayimgHelp, TheDocumentedTableIsOurs) {
  const char* root = std::getenv("RAYPRO_ROOT");
  const std::string page = ReadFile(std::string(root ? root : ".") + "/docs/options.md");
  EXPECT_TRUE(Has(page, Help(program, "markdown"))) << "run script/update_docs.sh";
}

}  // namespace
}  // namespace ray::rayimg
