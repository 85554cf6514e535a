// The documentation shows the current output of a program, except for times.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "tests/Project.h"
#include "tests/source/app/Program.h"

namespace ray::testing {
namespace {

/// Returns the lines after `command` in a page that have its indentation, up to the first line that does not.
std::string TranscriptOf(const std::string& page, const std::string& command) {
  const std::string indent = "    ";
  std::istringstream lines(page.substr(page.find(indent + command + "\n")));
  std::string line, transcript;
  std::getline(lines, line);
  while (std::getline(lines, line) && (line.empty() || line.starts_with(indent)))
    transcript += (line.empty() ? line : line.substr(indent.size())) + "\n";
  return transcript.substr(transcript.find_first_not_of('\n'));
}

/// Returns the samples per pixel that -advise states for some settings.
struct AdvisedSamples {
  std::string settings;
  double samples;
};

/// Returns the rows of the table that -advise prints.
std::vector<AdvisedSamples> SamplesOfAdvice(const std::string& advice) {
  static const std::regex row(R"((as requested|-\w+ \w+) +([0-9.]+) +[0-9.]+)");
  std::vector<AdvisedSamples> rows;
  std::istringstream lines(advice);
  std::smatch found;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_match(line, found, row)) rows.push_back({found[1], std::stod(found[2])});
  return rows;
}

// Regression: the page showed the output of an earlier version.
TEST(Transcripts, AdviceOfTheDocsIsTheProgramsOutput) {
  NEEDS_THE_PROGRAM();
  const std::string command = "raypro scenes/hello.scn -width 512 -height 512 -advise";
  const std::string shown = TranscriptOf(ReadFile(project::Root() / "docs/accuracy.md"), command);
  const std::string scene = (project::Root() / "scenes/hello.scn").string();
  const std::string now = RunProgram({scene, "-width", "512", "-height", "512", "-advise"}).output;
  const auto heading_of = [](const std::string& text) { return text.substr(0, text.find("\nas requested")); };
  // Much slower or faster machines have time for fewer or more squares, which need other samples.
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
