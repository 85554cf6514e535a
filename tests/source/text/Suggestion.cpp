#include "source/text/Suggestion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace ray {
namespace {

/// Returns the distance by the whole table, from the definition, without skipping rows.
std::size_t DistanceByTable(const std::string& a, const std::string& b) {
  std::vector table(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& d = table[i][j];
      d = i == 0 || j == 0 ? std::max(i, j) : table[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      if (i > 0) d = std::min(d, table[i - 1][j] + 1);
      if (j > 0) d = std::min(d, table[i][j - 1] + 1);
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) d = std::min(d, table[i - 2][j - 2] + 1);
    }
  return table[a.size()][b.size()];
}

std::string RandomWord(std::mt19937& random) {
  std::string word(1 + random() % 9, ' ');
  const auto letters = 1 + random() % 5;
  for (char& c : word) c = static_cast<char>('a' + random() % letters);
  return word;
}

std::string FirstOfTheNearest(const std::string& word, const std::vector<std::string>& choices) {
  const auto distance = [&](const std::string& choice) { return DistanceByTable(word, choice); };
  const auto nearest = std::ranges::min_element(choices, {}, distance);
  return distance(*nearest) <= word.size() / 3 ? "did you mean '" + *nearest + "'?" : "";
}

// Words that cannot be the nearest are abandoned early; none that is the nearest may be lost by that.
TEST(Suggestion, IsTheFirstOfTheNearestWords) {
  std::mt19937 random(1);
  int suggested = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::string word = RandomWord(random);
    std::vector<std::string> choices(5);
    std::ranges::generate(choices, [&] { return RandomWord(random); });
    const std::vector<std::string_view> views(choices.begin(), choices.end());
    const std::string expected = FirstOfTheNearest(word, choices), got = Suggestion(word, views, "words");
    ASSERT_EQ(got.starts_with("did you mean") ? got : "", expected) << word;
    if (!expected.empty()) ++suggested;
  }
  EXPECT_GT(suggested, 1000);
}

}  // namespace
}  // namespace ray
