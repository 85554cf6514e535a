// Answers of the programs to commands. The files of tests/app contain commands with their answers: commands.txt those
// that users of other renderers, and of the course's, type first; options.txt and rayimg.txt wrong ones; warnings.txt
// likely mistakes; files.txt commands with the wrong files; scenes.txt scenes. RAYTESTS_RECORD=1 records the answers
// again: read the difference.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>

#include "R2/ImageFile.h"
#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

namespace fs = std::filesystem;

/// The marks that begin a line of the command and of its answer in the file.
constexpr const char* prompt = "$ ";
constexpr const char* output_mark = "  | ";
constexpr const char* error_mark = "  ! ";
constexpr const char* file_mark = "  + ";  // a file that a failed command leaves behind
constexpr const char* header =
    "# Commands, exit statuses, the first lines on standard error (!) and standard output (|), and files that\n"
    "# commands which fail leave behind (+), recorded with\n"
    "# RAYTESTS_RECORD=1 build/raytests --gtest_filter=Commands.*\n";
constexpr std::size_t most_lines = 6;  // per stream; long answers are tested elsewhere

constexpr std::array transcripts{"commands.txt", "options.txt", "rayimg.txt",
                                 "warnings.txt", "files.txt",   "scenes.txt"};
std::string DataFile(const std::string& name) { return (project::Root() / "tests/app" / name).string(); }

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

/// Returns the first lines, each after its mark. Times, speeds and the features of a build vary and are replaced, and a
/// new command changes no answer.
std::string Shown(std::string text, const std::string& mark) {
  static const std::pair<std::regex, const char*> varying[] = {
      {std::regex(R"([0-9.]+ s [0-9.]+ Mrays/s)"), "TIME"},
      {std::regex(R"(raypro \d+\.\d+\.\d+(\nbuilt from: [^\n]*)?|built with: [^\n]*)"), "BUILD"},
      {std::regex("commands are [a-z_, ]+"), "commands are ALL"}};
  for (const auto& [what, by] : varying) text = std::regex_replace(text, what, by);
  std::istringstream lines(text);
  std::string shown;
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    if (count < most_lines) shown += mark + line + "\n";
  return count > most_lines ? shown + mark + "...\n" : shown;
}

/// Returns the command, its exit status and its output in the format of the file.
std::string Answer(const std::string& command) {
  const Folder place;
  const TemporaryFolder aside;
  fs::create_directory(aside / "bin");
  for (const auto& [name, variable] : {std::pair{"raypro", "RAYPRO"}, {"rayimg", "RAYIMG"}, {"rayview", "RAYVIEW"}})
    if (const char* program = ProgramName(variable)) fs::create_symlink(program, aside / ("bin/" + std::string(name)));
  WriteFile(aside / "command", command + "\n");
  const int ended =
      std::system(("cd '" + place.Path().string() + "' && PATH='" + aside / "bin" + "':$PATH TERM=dumb sh '" +
                   aside / "command" + "' >'" + aside / "output" + "' 2>'" + aside / "error" + "' </dev/null")
                      .c_str());
  const int status = WEXITSTATUS(ended);
  std::vector<std::string> files = place.Others(place.known);
  std::ranges::sort(files);
  std::string left;
  if (status)
    for (const std::string& file : files) left += file_mark + file + "\n";
  return prompt + command + "\n  " + std::to_string(status) + "\n" + Shown(ReadFile(aside / "error"), error_mark) +
         Shown(ReadFile(aside / "output"), output_mark) + left;
}

/// Returns the answers of the file, each of which begins with its command.
std::vector<std::string> Recorded(const std::string& name) {
  std::istringstream lines(ReadFile(DataFile(name)));
  std::vector<std::string> answers;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(prompt))
      answers.push_back(line + "\n");
    else if (!answers.empty())
      answers.back() += line + "\n";
  return answers;
}

std::string CommandOf(const std::string& answer) {
  const std::size_t begin = std::string(prompt).size();
  return answer.substr(begin, answer.find('\n') - begin);
}

TEST(Commands, AreAnsweredAsRecorded) {
  NEEDS_THE_PROGRAM();
  NEEDS_RAYIMG();
  NEEDS_RAYVIEW();
  if (!R2::FormatForName("a.exr") || !Has(RunProgram({"-list", "scenes"}).output, ".yaml"))
    GTEST_SKIP() << "answers that list formats are recorded with OpenEXR and yaml-cpp";
  for (const char* name : transcripts) {
    const std::vector<std::string> recorded = Recorded(name);
    EXPECT_GE(recorded.size(), 20u) << name;
    std::string all;
    for (const std::string& answer : recorded) {
      const std::string now = Answer(CommandOf(answer));
      EXPECT_EQ(now, answer);
      all += now;
    }
    if (std::getenv("RAYTESTS_RECORD")) WriteFile(DataFile(name), header + all);
  }
}

// A script that checks only the exit status must not take an answer for an image. One line, on standard error alone,
// states the mistake.
TEST(Commands, ThatAreWrongAreAnsweredInOneLine) {
  for (const char* name : {"options.txt", "rayimg.txt"})
    for (const std::string& answer : Recorded(name)) {
      EXPECT_FALSE(Has(answer, "\n  0\n")) << answer;
      EXPECT_EQ(std::count(answer.begin(), answer.end(), '\n'), 3) << answer;
      EXPECT_TRUE(Has(answer, std::string("\n") + error_mark)) << answer;
    }
}

TEST(Commands, SucceedOnlyWithAnImageUnlessTextWasRequested) {
  const std::regex asks_for_words(" (-h|-?-help|-?-version|-list|-check|-info|-debugpixel|-complete|-man)\\b|^rayimg");
  for (const std::string& answer : Recorded("commands.txt")) {
    const bool succeeds = Has(answer, "\n  0\n");
    const bool has_image = Has(answer, " spp TIME") || Has(answer, "> out.png");
    EXPECT_TRUE(!succeeds || has_image || std::regex_search(CommandOf(answer), asks_for_words)) << answer;
  }
}

}  // namespace
}  // namespace ray::testing
