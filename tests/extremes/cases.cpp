// The list of hard inputs and the tests that name their numbers are one.

#include <gtest/gtest.h>

#include <cctype>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "tests/Project.h"

namespace {

/// Numbers and words of tests/extremes/cases.txt.
std::map<std::string, std::string> Cases() {
  std::map<std::string, std::string> cases;
  std::ifstream file(project::Root() / "tests" / "extremes" / "cases.txt");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    const std::size_t space = line.find(' ');
    EXPECT_TRUE(cases.emplace(line.substr(0, space), line.substr(space + 1)).second) << line << " stands there twice";
  }
  return cases;
}

bool IsNumber(const std::string& word) {
  if (word.size() < 2 || word[0] < 'A' || word[0] > 'M') return false;
  return std::all_of(word.begin() + 1, word.end(), [](unsigned char c) { return std::isdigit(c); });
}

/// The case numbers that names of tests begin with: A1 and A3 of "A1_A3_ScaledAndMirrored".
std::set<std::string> NumbersOfTests() {
  std::set<std::string> numbers;
  const auto& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i)
    for (int k = 0; k < all.GetTestSuite(i)->total_test_count(); ++k) {
      std::string name = all.GetTestSuite(i)->GetTestInfo(k)->name();
      for (std::size_t end; (end = name.find('_')) != std::string::npos && IsNumber(name.substr(0, end));
           name.erase(0, end + 1))
        numbers.insert(name.substr(0, end));
    }
  return numbers;
}

TEST(ExtremesList, EveryCaseHasATestOrSaysWhyNot) {
  const auto cases = Cases();
  const auto numbers = NumbersOfTests();
  EXPECT_EQ(cases.size(), 137u);
  for (const std::string& number : numbers) EXPECT_TRUE(cases.contains(number)) << number;
  for (const auto& [number, words] : cases)
    EXPECT_NE(numbers.contains(number), words.starts_with("open:")) << number << ' ' << words;
}

}  // namespace
