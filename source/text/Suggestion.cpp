#include "source/text/Suggestion.h"

#include <algorithm>
#include <vector>

#include "source/text/LowerCase.h"

namespace ray {
namespace {

// Longer words are not typing errors; the limit keeps the quadratic comparison small.
constexpr std::size_t max_word = 40;

/// Returns the number of insertions, deletions, changes and swaps of neighbors that turn one word into the other,
/// ignoring letter case; at most `most`, which is often clear from the first letters. Source: Damerau, A technique for
/// computer detection and correction of spelling errors (1964), as the restricted distance computed by dynamic
/// programming over three rows. The minimum of a row never decreases from one row to the next.
std::size_t Distance(std::string_view a, std::string_view b, std::size_t most) {
  const std::size_t apart = std::max(a.size(), b.size()) - std::min(a.size(), b.size());
  if (apart >= most) return most;
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    std::size_t least = row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = LowerCase(a[i - 1]) == LowerCase(b[j - 1]);
      row[j] = std::min(std::min(last[j], row[j - 1]) + 1, last[j - 1] + (same ? 0 : 1));
      if (i > 1 && j > 1 && LowerCase(a[i - 1]) == LowerCase(b[j - 2]) && LowerCase(a[i - 2]) == LowerCase(b[j - 1]))
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      least = std::min(least, row[j]);
    }
    if (least >= most) return most;
  }
  return std::min(row[b.size()], most);
}

}  // namespace

std::string_view Nearest(std::string_view word, std::span<const std::string_view> choices) {
  if (word.size() > max_word) return {};
  std::size_t nearest = word.size() / 3 + 1;  // 'spere', 'poinlight', but not 'cat' for 'box'
  std::string_view best;
  for (const std::string_view choice : choices) {
    const std::size_t distance = Distance(word, choice, nearest);
    if (distance >= nearest) continue;
    nearest = distance;
    best = choice;
  }
  return best;
}

std::string Suggestion(std::string_view word, std::span<const std::string_view> choices, const std::string& plural) {
  const std::string_view best = Nearest(word, choices);
  if (!best.empty()) return "did you mean '" + std::string(best) + "'?";
  std::string all;
  for (const std::string_view choice : choices) all += (all.empty() ? "" : ", ") + std::string(choice);
  return plural + " are " + all;
}

}  // namespace ray
