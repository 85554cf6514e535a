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

/// How many samples per pixel -advise says that some settings take.
struct AdvisedSamples {
  std::string settings;
  double samples;
};

/// The rows of the table that -advise prints.
std::vector<AdvisedSamples> SamplesOfAdvice(const std::string& advice) {
  static const std::regex row(R"((as asked|-\w+ \w+) +([0-9.]+) +[0-9.]+)");
  std::vector<AdvisedSamples> rows;
  std::istringstream lines(advice);
  std::smatch found;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, found, row)) rows.push_back({found[1], std::stod(found[2])});
  return rows;
}

// It went on showing the answer of an earlier version.
TEST(Transcripts, AdviceOfTheDocsIsWhatIsPrinted) {
  NEEDS_THE_PROGRAM();
  const std::string command = "raypro scenes/hello.scn -width 512 -height 512 -advise";
  const std::string shown = TranscriptOf(ReadFile(project::Root() / "docs/accuracy.md"), command);
  const std::string scene = (project::Root() / "scenes/hello.scn").string();
  const std::string now = RunProgram({scene, "-width", "512", "-height", "512", "-advise"}).output;
  const auto heading_of = [](const std::string& text) { return text.substr(0, text.find("\nas asked")); };
  // Machines that are much slower or faster have time for fewer or more squares, which need other samples.
  if (!now.starts_with("From 256 squares"))
    GTEST_SKIP() << "not as fast as the docs' machine: " << now.substr(0, now.find('\n'));
  EXPECT_EQ(heading_of(now), heading_of(shown));
  const std::vector<AdvisedSamples> rows = SamplesOfAdvice(now), in_docs = SamplesOfAdvice(shown);
  EXPECT_GE(in_docs.size(), 6u) << shown;
  ASSERT_EQ(rows.size(), in_docs.size()) << now;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].settings, in_docs[i].settings);
    EXPECT_EQ(rows[i].samples, in_docs[i].samples) << rows[i].settings;
  }
}

}  // namespace
}  // namespace ray::testing
