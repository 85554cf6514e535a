#include "source/grade/Matrix.h"

#include <algorithm>

#include "source/grade/Comparison.h"
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
  const R2::Image *first = images.With(a), *second = images.With(b);
  if (!first || !second) return false;
  constexpr double alike = 0.9;
  const auto share = ShareExplained(MakeSubmission({*first}, false, images), images, b);
  return share && *share > alike;
}

enum class Verdict { right, wrong, silent, invisible };

struct Tried {
  Verdict verdict;
  std::string text;
};

Tried Try(SceneImages& images, const MistakeList& mistakes) {
  if (!IsVisible(images, mistakes)) return {Verdict::invisible, "-"};
  const Submission student = MakeSubmission({images.AsOfAnother(mistakes)}, false, images);
  const Explanation found = Explain(student, images);
  if (found.mistakes.empty()) return {Verdict::silent, "silent"};
  MistakeList any = found.alternatives;
  const bool is_among = mistakes.size() == 1 && std::ranges::find(any, mistakes[0]) != any.end();
  if (is_among || LookAlike(images, mistakes, found.mistakes))
    return {Verdict::right,
            NamesOf(found.mistakes) == NamesOf(mistakes) ? "right" : "right, as " + NamesOf(found.mistakes)};
  return {Verdict::wrong, "WRONG: " + NamesOf(found.mistakes)};
}

void TryInEach(std::vector<std::unique_ptr<SceneImages>>& scenes, const MistakeList& mistakes, Verdicts& verdicts) {
  std::string line = NamesOf(mistakes) + ":";
  bool is_seen = false;
  for (const auto& images : scenes) {
    const Tried tried = Try(*images, mistakes);
    line += "  " + images->scene().name + " " + tried.text;
    is_seen |= tried.verdict != Verdict::invisible;
    verdicts.right += tried.verdict == Verdict::right;
    verdicts.wrong += tried.verdict == Verdict::wrong;
    verdicts.silent += tried.verdict == Verdict::silent;
  }
  verdicts.invisible += !is_seen;
  verdicts.lines.push_back(line);
}

}  // namespace

Verdicts TryMistakes(std::vector<std::unique_ptr<SceneImages>>& scenes, int pairs) {
  Verdicts verdicts;
  for (const Mistake* mistake : Mistakes()) TryInEach(scenes, {mistake}, verdicts);
  const auto count = Mistakes().size();
  for (int i = 0; i < pairs; ++i) {
    const RandomKey key = RandomKey(7).Child(static_cast<std::uint64_t>(i));
    const Mistake* first = Mistakes()[key.Child(1).Bits() % count];
    const Mistake* second = Mistakes()[key.Child(2).Bits() % count];
    if (first != second) TryInEach(scenes, {first, second}, verdicts);
  }
  return verdicts;
}

}  // namespace ray::grade
