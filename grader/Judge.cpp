#include "grader/Grader.h"

#include <algorithm>
#include <cmath>

#include "R2/compare/Difference.h"
#include "grader/Detectors.h"
#include "source/text/NumberText.h"

namespace ray::grade {
namespace {

std::string Percent(double share) { return Rounded(100 * share, 3) + "%"; }

std::string TitlesOf(const MistakeList& mistakes) {
  std::string titles;
  for (const Mistake* mistake : mistakes) titles += (titles.empty() ? "" : ", and ") + std::string(mistake->title);
  return titles;
}

void Name(const Explanation& explanation, SceneResult& result) {
  result.outcome = SceneResult::Outcome::known_mistake;
  result.explained = explanation.share;
  for (const Mistake* mistake : explanation.mistakes)
    result.mistakes += (result.mistakes.empty() ? "" : "+") + std::string(mistake->name);
  result.headline = Percent(result.percent / 100) +
                    " of the pixels differ, as with: " + TitlesOf(explanation.mistakes) + " (" +
                    Percent(explanation.share) + " of the difference).";
  for (const Mistake* mistake : explanation.mistakes) {
    result.remarks.push_back(std::string("Expected: ") + mistake->expected);
    result.remarks.push_back(std::string("Look here: ") + mistake->hint);
  }
  if (explanation.alternatives.empty() || explanation.mistakes.size() > 1) return;
  std::string others;
  for (const Mistake* mistake : explanation.alternatives)
    others += (others.empty() ? "" : "; ") + std::string(mistake->title);
  result.remarks.push_back("In this scene it looks the same as: " + others + ".");
}

/// Full points where all is well. Else fewer the more pixels differ, and never fewer than for known mistakes.
double ScoreOf(const SceneResult& result, const Suite& suite, const SuiteScene& scene) {
  constexpr double worthless = 25;  // percent of the pixels that differ
  if (result.outcome == SceneResult::Outcome::right) return scene.points;
  const double kept = std::clamp(1 - result.percent / worthless, 0.0, 1.0);
  const bool is_known = result.outcome == SceneResult::Outcome::known_mistake;
  return scene.points * std::max(kept, is_known ? suite.explained : 0.0);
}

}  // namespace

void Judge(const std::vector<R2::Image>& runs, bool is_jpeg, const Suite& suite, SceneImages& images,
           SceneResult& result) {
  const Submission student = MakeSubmission(runs, is_jpeg, images);
  const Comparison found = Compare(student, images);
  result.percent = found.Percent();
  result.expected = images.Reference();
  result.actual = student.image;
  result.difference = R2::SignedDifference(student.image, images.Reference());
  if (result.percent <= images.scene().allowed) {
    result.outcome = SceneResult::Outcome::right;
    result.headline = found.differing == 0 ? "The image is right."
                                           : "The image is right, but for " + Percent(result.percent / 100) +
                                                 " of its pixels, which is allowed.";
  } else {
    result.worst_x = found.worst_x, result.worst_y = found.worst_y;
    result.ray_tree = images.RayTreeAt(found.worst_x, found.worst_y);
    const Verdict verdict = VerdictOn(student, found, images);
    if (verdict.kind == Verdict::Kind::mistakes) {
      Name(verdict.explanation, result);
    } else {
      result.outcome = SceneResult::Outcome::different;
      result.headline = Percent(result.percent / 100) + " of the pixels differ.";
      if (!verdict.remark.empty())
        result.remarks.push_back(verdict.remark);
      else if (const auto remark = TerminatorRemark(student, found, images))
        result.remarks.push_back(*remark);
      else
        result.remarks.push_back(
            "No mistake that raygrade knows makes such an image. Begin with the pixel below: what do your "
            "rays do there?");
    }
  }
  result.score = ScoreOf(result, suite, images.scene());
}

}  // namespace ray::grade
