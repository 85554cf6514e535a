#include "grader/Matrix.h"

#include <algorithm>

#include "grader/Judge.h"
#include "source/sample/Random.h"
#include "source/text/NumberText.h"

namespace ray::grade {
namespace {

/// Returns true if the grader cannot distinguish the images of the two hypotheses in any scene.
bool LookAlike(std::vector<std::unique_ptr<SceneImages>>& scenes, const Hypothesis& a, const Hypothesis& b) {
  return std::ranges::all_of(scenes, [&](const auto& images) {
    const R2::Image first = ImageWith(*images, a), second = ImageWith(*images, b);
    const Submission student = MakeSubmission({first}, *images);
    return Compare(student, images->Cells(second), *images).Percent() <= images->scene().allowed;
  });
}

/// Returns the images of a student who made these mistakes.
std::vector<HandedIn> ImagesOf(std::vector<std::unique_ptr<SceneImages>>& scenes, const MistakeList& mistakes) {
  std::vector<HandedIn> handed_in;
  for (const auto& images : scenes) {
    R2::Image image = images->AsOfAnother(mistakes);
    // Mistakes that do not apply to a scene leave it unchanged.
    if (image.Width() == 0) image = images->AsOfAnother({});
    handed_in.push_back({images.get(), {image}, false, handed_in.size()});
  }
  return handed_in;
}

/// Returns the scenes that the mistakes change visibly: "sphere 24%".
std::string ShownBy(std::vector<std::unique_ptr<SceneImages>>& scenes, const MistakeList& mistakes, double& most) {
  std::string text;
  for (const auto& images : scenes) {
    const double percent = PercentChanged(*images, mistakes);
    most = std::max(most, percent);
    if (percent > images->scene().allowed)
      text += (text.empty() ? "" : ", ") + images->scene().name + " " + Plain(percent, 2) + "%";
  }
  return text;
}

void TryOne(std::vector<std::unique_ptr<SceneImages>>& scenes, const Suite& suite, const MistakeList& mistakes,
            MatrixCounts& counts) {
  const Hypothesis made{mistakes, {}};
  MatrixRow row{made.Names(), {}, 0, MatrixRow::Outcome::invisible, {}};
  row.shown_by = ShownBy(scenes, mistakes, row.percent);
  if (!row.shown_by.empty()) {
    StudentResult student;
    student.scenes.resize(suite.scenes.size());
    const Findings findings = JudgeTogether(ImagesOf(scenes, mistakes), suite, student);
    using enum MatrixRow::Outcome;
    row.named = student.verdict.mistakes;
    if (findings.diagnosis && findings.diagnosis->kind == Diagnosis::Kind::named) {
      const bool is_same = findings.diagnosis->causes.Names() == row.mistakes ||
                           (!findings.diagnosis->causes.tone &&
                            std::ranges::is_permutation(findings.diagnosis->causes.mistakes, mistakes));
      const bool is_among = std::ranges::any_of(findings.diagnosis->alternatives, [&](const Hypothesis& other) {
        return other.Names() == row.mistakes;
      });
      row.outcome = is_same                                                             ? by_name
                    : is_among || LookAlike(scenes, made, findings.diagnosis->causes) ? same_image
                                                                                        : wrong;
    } else if (row.mistakes == "gamma" && findings.encoding != Encoding::linear) {
      row.outcome = by_name;
      row.named = row.mistakes;
    } else {
      const bool has_other_images = findings.diagnosis && findings.diagnosis->kind != Diagnosis::Kind::right;
      row.outcome = has_other_images ? silent : empty;
    }
  }
  ++counts.of[static_cast<std::size_t>(row.outcome)];
  counts.rows.push_back(std::move(row));
}

}  // namespace

std::string MatrixRow::Text() const {
  static constexpr std::array words{"right", "right, as ", "one color", "WRONG: ", "silent", "in no scene visible"};
  const std::string other = outcome == Outcome::same_image || outcome == Outcome::wrong ? named : "";
  return mistakes + ": " + words[static_cast<std::size_t>(outcome)] + other + (shown_by.empty() ? "" : "; " + shown_by);
}

MatrixCounts TryMistakes(std::vector<std::unique_ptr<SceneImages>>& scenes, const Suite& suite, int pairs) {
  MatrixCounts counts;
  for (const Mistake* mistake : Mistakes()) TryOne(scenes, suite, {mistake}, counts);
  const auto count = Mistakes().size();
  for (int i = 0; i < pairs; ++i) {
    const RandomKey key = RandomKey(7).Child(static_cast<std::uint64_t>(i));
    const Mistake* first = Mistakes()[key.Child(1).Bits() % count];
    const Mistake* second = Mistakes()[key.Child(2).Bits() % count];
    if (first != second) TryOne(scenes, suite, {first, second}, counts);
  }
  return counts;
}

}  // namespace ray::grade
