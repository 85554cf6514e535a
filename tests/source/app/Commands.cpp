// Answers of the programs to commands. Each file of tests/app has a subject, and a comment states what the commands
// below it show. A comment that begins with cases of tests/extremes/cases.txt, "K1, K2: Files outside...", names a test
// of its own. RAYTESTS_RECORD=1 records the answers again: read the difference.
//
//     # A light that nothing sees is reported.       what the answer shows
//     $ raypro - -check -quiet <<.                   a command, for sh
//     > sphere 0  0 0 0  1                           its further lines
//     > .
//       0                                            its exit status
//       ! <stdin>: warning: ...                      standard error
//       | files         1                            standard output
//       + out.png                                    a file that a failed command leaves behind
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>
#include <utility>

#include "R2/ImageFile.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;

/// The marks that begin a line of the command and of its answer in the file.
constexpr const char* comment_mark = "# ";
constexpr const char* prompt = "$ ";
constexpr const char* next_line_prompt = "> ";
constexpr const char* output_mark = "  | ";
constexpr const char* error_mark = "  ! ";
constexpr const char* file_mark = "  + ";  // a file that a failed command leaves behind
constexpr const char* header =
    "# Commands, exit statuses, the first lines on standard error (!) and standard output (|), and files that\n"
    "# commands which fail leave behind (+), recorded with\n"
    "# RAYTESTS_RECORD=1 build/raytests --gtest_filter=*Commands.*\n";
constexpr std::size_t most_errors = 40, most_output = 6;  // lines; long answers are tested elsewhere

std::string DataFile(const std::string& name) { return (project::Root() / "tests/app" / name).string(); }

std::vector<std::string> Transcripts() {
  std::vector<std::string> names;
  std::error_code ignored;  // without the folder, the tests that name a transcript fail
  for (const auto& entry : fs::directory_iterator(DataFile(""), ignored)) names.push_back(entry.path().stem());
  std::ranges::sort(names);
  return names;
}

void WriteImage(const std::string& file, int width, int height, float level) {
  R2::Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.Set(x, y, {level, level, level});
  const auto bytes = R2::FormatForName(file)->encode(image, {}, {});
  WriteFile(file, {bytes.begin(), bytes.end()});
}

/// A folder like a newcomer's, with images of every kind, valid and broken.
struct Folder : TemporaryFolder {
  Folder() {
    const std::string scene = "camera 0 0 6  0 0 -1  0 1 0  0.3  0.1 100\npoint_light 1 1 1  3 4 5  1 0 0\n";
    WriteFile(*this / "scene.scn", scene + "sphere -1  0 0 0  1\n");
    WriteFile(*this / "other.scn", scene + "box -1  -1 -1 -1  1 1 1\n");
    WriteFile(*this / "wrong.scn", scene + "spere -1  0 0 0  1\ntriangle -1  0 0 0  1 0 0  0 1 0\n");
    fs::create_directory(*this / "images");
    WriteImage(*this / "a.png", 4, 4, 0.5f);
    WriteImage(*this / "small.png", 2, 4, 0);
    WriteImage(*this / "light.pfm", 4, 4, 0);
    WriteImage(*this / "frame.jpg", 4, 4, 0.5f);
    WriteImage(*this / "wide.jpg", 6, 4, 0.5f);
    WriteFile(*this / "text.png", "this is no image\n");
    WriteFile(*this / "empty.exr", "");
    WriteFile(*this / "cut.pfm", ReadFile(*this / "light.pfm").substr(0, 60));
    WriteFile(*this / "huge.pfm", "PF\n1000000 1000000\n-1\n");
    for (const auto& entry : fs::directory_iterator(Path())) known.push_back(entry.path().filename());
  }
  std::vector<std::string> known;
};

/// Returns the first lines, each after its mark. Times, speeds, folders and the features of a build vary and are
/// replaced, progress is shown on slow machines only, and a new command changes no answer.
std::string Shown(std::string text, const std::string& mark, std::size_t most_lines, const std::string& folder) {
  static const std::pair<std::regex, const char*> varying[] = {
      {std::regex(R"([0-9.]+ s [0-9.]+ Mrays/s)"), "TIME"},
      {std::regex(R"( *\d+%  [^\n]* Mrays/s\n)"), ""},
      {std::regex(R"(raypro \d+\.\d+\.\d+(\nbuilt from: [^\n]*)?|built with: [^\n]*)"), "BUILD"},
      {std::regex("commands are [a-z_, ]+"), "commands are ALL"}};
  for (const auto& [what, by] : varying) text = std::regex_replace(text, what, by);
  const std::string root = fs::canonical(project::Root()).string();
  for (const auto& [path, by] : {std::pair(folder, "FOLDER"), std::pair(root, "ROOT")})
    for (std::size_t i; (i = text.find(path)) != std::string::npos;) text.replace(i, path.size(), by);
  std::istringstream lines(text);
  std::string shown;
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    if (count < most_lines) shown += mark + line + "\n";
  return count > most_lines ? shown + mark + "...\n" : shown;
}

/// Returns the exit status of the command and its output in the format of the file.
std::string AnswerTo(const std::string& command) {
  const Folder place;
  const TemporaryFolder aside;
  fs::create_directory(aside / "bin");
  for (const auto& [name, variable] : {std::pair{"raypro", "RAYPRO"}, {"rayimg", "RAYIMG"}, {"rayview", "RAYVIEW"}})
    if (const char* program = ProgramName(variable)) fs::create_symlink(program, aside / ("bin/" + std::string(name)));
  WriteFile(aside / "command", command + "\n");
  const int ended = std::system(("cd '" + place.Path().string() + "' && ROOT='" +
                                 fs::canonical(project::Root()).string() + "' PATH='" + aside / "bin" +
                                 "':$PATH TERM=dumb sh '" + aside / "command" + "' >'" + aside / "output" + "' 2>'" +
                                 aside / "error" + "' </dev/null")
                                    .c_str());
  const int status = WEXITSTATUS(ended);
  std::vector<std::string> files = place.Others(place.known);
  std::ranges::sort(files);
  std::string left;
  if (status)
    for (const std::string& file : files) left += file_mark + file + "\n";
  const auto shown = [&](const char* stream, const char* mark, std::size_t most) {
    return Shown(ReadFile(aside / stream), mark, most, place.Path().string());
  };
  return "  " + std::to_string(status) + "\n" + shown("error", error_mark, most_errors) +
         shown("output", output_mark, most_output) + left;
}

struct Recorded {
  std::string comment;  // including its marks
  std::string command;
  std::string answer{};
  std::string test{};  // the test of its own that its comment names

  std::string WithAnswer(const std::string& now) const {
    return comment + prompt + std::regex_replace(command, std::regex("\n"), std::string("\n") + next_line_prompt) +
           "\n" + now;
  }
};

/// Returns "K1_K2_FilesOutsideAreRefused" for "# K1, K2: Files outside are refused, and ...", and nothing for a comment
/// that does not begin with cases.
std::string TestOf(const std::string& comment) {
  static const std::regex cases_and_sentence("# ((?:[A-M][0-9]+(?:, |: ))+)([A-Za-z' -]+)");
  std::smatch found;
  if (!std::regex_search(comment, found, cases_and_sentence, std::regex_constants::match_continuous)) return {};
  std::string name = std::regex_replace(found[1].str(), std::regex("(, |: )"), "_");
  std::istringstream words(found[2]);
  for (std::string word; words >> word;) {
    std::erase_if(word, [](char c) { return c == '\'' || c == '-'; });
    name += static_cast<char>(std::toupper(word[0]));
    name += word.substr(1);
  }
  return name;
}

std::vector<Recorded> ReadTranscript(const std::string& name) {
  std::istringstream lines(ReadFile(DataFile(name + ".txt")).substr(std::string(header).size()));
  std::vector<Recorded> all;
  std::string comment, test;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(comment_mark)) {
      comment += line + "\n";
      test = TestOf(comment);
    } else if (line.starts_with(prompt))
      all.push_back({.comment = std::exchange(comment, ""),
                     .command = line.substr(std::string(prompt).size()),
                     .test = test});
    else if (line.starts_with(next_line_prompt))
      all.back().command += "\n" + line.substr(std::string(next_line_prompt).size());
    else
      all.back().answer += line + "\n";
  return all;
}

/// Returns false if this build lacks a format that the answer shows, or the program.
bool CanBeRun(const Recorded& one) {
  static const bool has_exr = R2::FormatForName("a.exr"),
                    has_yaml = Has(RunProgram({"-list", "scenes"}).output, ".yaml");
  const std::string all = one.command + one.answer;
  return (has_exr || !Has(all, "exr")) && (has_yaml || !std::regex_search(all, std::regex("ya?ml"))) &&
         (ProgramName("RAYVIEW") || !Has(one.command, "rayview "));
}

/// Expects the recorded answer and returns the current one; the recorded one if this build cannot run the command.
std::string ExpectedAnswer(const Recorded& one) {
  const std::string now = CanBeRun(one) ? AnswerTo(one.command) : one.answer;
  EXPECT_EQ(one.WithAnswer(now), one.WithAnswer(one.answer));
  return now;
}

class Commands : public ::testing::TestWithParam<std::string> {};

TEST_P(Commands, AreAnsweredAsRecorded) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  const std::vector<Recorded> recorded = ReadTranscript(GetParam());
  const bool records = std::getenv("RAYTESTS_RECORD");
  EXPECT_FALSE(recorded.empty());
  std::string all;
  for (const Recorded& one : recorded)
    if (records || one.test.empty()) all += one.WithAnswer(ExpectedAnswer(one));
  if (records) WriteFile(DataFile(GetParam() + ".txt"), header + all);
}

INSTANTIATE_TEST_SUITE_P(Of, Commands, ::testing::ValuesIn(Transcripts()),
                         [](const auto& transcript) { return transcript.param; });

/// The test that a comment names.
class NamedCommands : public ::testing::Test {
 public:
  explicit NamedCommands(std::vector<Recorded> commands) : commands_(std::move(commands)) {}
  void TestBody() override {
    NEEDS_THE_PROGRAM();
    NEEDS_RAYIMG();
    for (const Recorded& one : commands_) ExpectedAnswer(one);
  }

 private:
  std::vector<Recorded> commands_;
};

[[maybe_unused]] const bool are_registered = [] {
  std::map<std::string, std::vector<Recorded>> by_test;
  for (const std::string& name : Transcripts())
    for (const Recorded& one : ReadTranscript(name))
      if (!one.test.empty()) by_test[one.test].push_back(one);
  for (const auto& [test, commands] : by_test)
    ::testing::RegisterTest("Extremes", test.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                            [commands]() -> ::testing::Test* { return new NamedCommands(commands); });
  return true;
}();

// A script that checks only the exit status must not take an answer for an image. One line, on standard error alone,
// states the mistake.
TEST(AnswersToCommands, ThatAreWrongAreOneLine) {
  for (const char* name : {"options", "rayimg"})
    for (const Recorded& one : ReadTranscript(name)) {
      EXPECT_FALSE(one.answer.starts_with("  0\n")) << one.command;
      EXPECT_EQ(std::ranges::count(one.answer, '\n'), 2) << one.command;
      EXPECT_TRUE(Has(one.answer, std::string("\n") + error_mark)) << one.command;
    }
}

TEST(AnswersToCommands, AreImagesUnlessTextWasRequested) {
  const std::regex asks_for_words(" (-h|-?-help|-?-version|-list|-check|-info|-debugpixel|-complete|-man)\\b|^rayimg");
  for (const Recorded& one : ReadTranscript("commands")) {
    const bool succeeds = one.answer.starts_with("  0\n");
    const bool has_image = Has(one.answer, " spp TIME") || Has(one.command, "> out.png");
    EXPECT_TRUE(!succeeds || has_image || std::regex_search(one.command, asks_for_words)) << one.command;
  }
}

}  // namespace
}  // namespace ray::testing
