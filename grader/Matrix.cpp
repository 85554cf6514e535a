#include "grader/Matrix.h"

#include <algorithm>

#include "grader/Comparison.h"
#include "grader/Detectors.h"
#include "source/sample/Random.h"

namespace ray::grade {
namespace {

std::string NamesOf(const MistakeList& mistakes) {
  std::string names;
  for (const Mistake* mistake : mistakes) names += (names.empty() ? "" : "+") + std::string(mistake->name);
  return names;
}

/// Whether the image with these mistakes is, to the grader's eye, that with the others.
bool LookAlike(SceneImages& images, const MistakeList& a, const MistakeList& b) {
  if (std::ranges::is_permutation(a, b)) return true;
  const auto first = images.With(a), second = images.With(b);
  if (!first || !second) return false;
  constexpr double alike = 0.9;
  const auto share = ShareExplained(MakeSubmission({*first}, false, images), images, b);
  return share && *share > alike;
}

enum class Outcome { by_name, right, told, wrong, silent, invisible };

struct Tried {
  Outcome outcome;
  std::string text;
};

Tried Try(SceneImages& images, const MistakeList& mistakes) {
  if (!IsVisible(images, mistakes)) return {Outcome::invisible, "-"};
  const Submission student = MakeSubmission({images.AsOfAnother(mistakes)}, false, images);
  const Verdict verdict = VerdictOn(student, Compare(student, images), images);
  switch (verdict.kind) {
    case Verdict::Kind::empty:
      return {Outcome::told, "told"};
    case Verdict::Kind::specks:
      return {Outcome::wrong, "WRONG: " + verdict.remark};
    case Verdict::Kind::unknown:
      return {Outcome::silent, "silent"};
    case Verdict::Kind::mistakes:
      break;
  }
  const Explanation& found = verdict.explanation;
  MistakeList any = found.alternatives;
  const bool is_among = mistakes.size() == 1 && std::ranges::find(any, mistakes[0]) != any.end();
  if (std::ranges::is_permutation(mistakes, found.mistakes)) return {Outcome::by_name, "right"};
  if (is_among || LookAlike(images, mistakes, found.mistakes))
    return {Outcome::right, "right, as " + NamesOf(found.mistakes)};
  return {Outcome::wrong, "WRONG: " + NamesOf(found.mistakes)};
}

void TryInEach(std::vector<std::unique_ptr<SceneImages>>& scenes, const MistakeList& mistakes, MatrixCounts& counts) {
  std::string line = NamesOf(mistakes) + ":";
  bool is_seen = false;
  for (const auto& images : scenes) {
    const Tried tried = Try(*images, mistakes);
    line += "  " + images->scene().name + " " + tried.text;
    is_seen |= tried.outcome != Outcome::invisible;
    counts.by_name += tried.outcome == Outcome::by_name;
    counts.right += tried.outcome == Outcome::right || tried.outcome == Outcome::by_name;
    counts.told += tried.outcome == Outcome::told;
    counts.wrong += tried.outcome == Outcome::wrong;
    counts.silent += tried.outcome == Outcome::silent;
  }
  counts.invisible += !is_seen;
  counts.lines.push_back(line);
}

}  // namespace

MatrixCounts TryMistakes(std::vector<std::unique_ptr<SceneImages>>& scenes, int pairs) {
  MatrixCounts counts;
  for (const Mistake* mistake : Mistakes()) TryInEach(scenes, {mistake}, counts);
  const auto count = Mistakes().size();
  for (int i = 0; i < pairs; ++i) {
    const RandomKey key = RandomKey(7).Child(static_cast<std::uint64_t>(i));
    const Mistake* first = Mistakes()[key.Child(1).Bits() % count];
    const Mistake* second = Mistakes()[key.Child(2).Bits() % count];
    if (first != second) TryInEach(scenes, {first, second}, counts);
  }
  return counts;
}

}  // namespace ray::grade
