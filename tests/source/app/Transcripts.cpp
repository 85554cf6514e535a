// What the documentation shows of a program's answers is what the program answers, but for what clocks say.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

/// The lines behind `command` in a page that are indented as it is, up to the first that is not.
std::string TranscriptOf(const std::string& page, const std::string& command) {
  const std::string indent = "    ";
  std::istringstream lines(page.substr(page.find(indent + command + "\n")));
  std::string line, transcript;
  std::getline(lines, line);
  while (std::getline(lines, line) && (line.empty() || line.starts_with(indent)))
    transcript += (line.empty() ? line : line.substr(indent.size())) + "\n";
  return transcript.substr(transcript.find_first_not_of('\n'));
}

/// What -advise says of one choice of settings.
struct AdvisedError {
  std::string settings;
  double error;  // in 255ths
};

/// The rows of the table that -advise prints, and the error that -denoise leaves.
std::vector<AdvisedError> ErrorsOfAdvice(const std::string& advice) {
  static const std::regex row(R"((as asked|-\w+ \w+) +([0-9.]+)/255 +[0-9.]+ +[0-9.]+)");
  static const std::regex denoised(R"((With -denoise, \d+ samples) leave an error of ([0-9.]+)/255 instead .*)");
  std::vector<AdvisedError> errors;
  std::istringstream lines(advice);
  std::smatch found;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, found, row) || std::regex_match(line, found, denoised))
      errors.push_back({found[1], std::stod(found[2])});
  return errors;
}

// It went on showing the answer of an earlier version.
TEST(Transcripts, AdviceOfTheDocsIsWhatIsPrinted) {
  NEEDS_THE_PROGRAM();
  const std::string command = "raypro scenes/hello.scn -width 512 -height 512 -advise";
  const std::string shown = TranscriptOf(ReadFile(project::Root() / "docs/accuracy.md"), command);
  const std::string scene = (project::Root() / "scenes/hello.scn").string();
  const std::string now = RunProgram({scene, "-width", "512", "-height", "512", "-advise"}).output;
  const auto heading_of = [](const std::string& text) { return text.substr(0, text.find("\nas asked")); };
  // A busy machine has no time for all squares, and fewer squares have other errors.
  if (!now.starts_with("From 16 squares"))
    GTEST_SKIP() << "too slow for all squares: " << now.substr(0, now.find('\n'));
  EXPECT_EQ(heading_of(now), heading_of(shown));
  const std::vector<AdvisedError> errors = ErrorsOfAdvice(now), in_docs = ErrorsOfAdvice(shown);
  EXPECT_GE(in_docs.size(), 6u) << shown;
  ASSERT_EQ(errors.size(), in_docs.size()) << now;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    EXPECT_EQ(errors[i].settings, in_docs[i].settings);
    // Settings that took longer than usual were tried on fewer squares.
    EXPECT_NEAR(errors[i].error, in_docs[i].error, 0.25 * in_docs[i].error) << errors[i].settings;
  }
}

}  // namespace
}  // namespace ray::testing
