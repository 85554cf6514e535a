#include "grader/Judge.h"

#include <algorithm>

#include "R2/compare/Difference.h"
#include "grader/Detectors.h"
#include "grader/JpegTolerance.h"
#include "source/text/NumberText.h"

namespace ray::grade {
namespace {

using Outcome = SceneResult::Outcome;

std::string Percent(double share) { return Plain(100 * share, 3) + "%"; }

std::string Differing(const SceneResult& result) { return Percent(result.percent / 100) + " of the pixels differ"; }

/// Returns full points if everything is right. Otherwise fewer for more differing pixels, but never fewer than for
/// known mistakes.
double ScoreOf(const SceneResult& result, const Suite& suite) {
  constexpr double worthless = 25;  // percentage of differing pixels
  if (result.outcome == Outcome::right) return result.points;
  const double kept = std::clamp(1 - result.percent / worthless, 0.0, 1.0);
  return result.points * std::max(kept, result.outcome == Outcome::known_mistake ? suite.explained : 0.0);
}

std::string JoinedWith(const std::vector<std::string>& words, const char* between) {
  std::string joined;
  for (const std::string& word : words) joined += (joined.empty() ? "" : between) + word;
  return joined;
}

std::vector<std::string> HintsOf(const Hypothesis& causes) {
  std::vector<std::string> hints;
  for (const Mistake* mistake : causes.mistakes) {
    hints.push_back(std::string("Expected: ") + mistake->expected);
    hints.push_back(std::string("Look here: ") + mistake->hint);
  }
  if (causes.tone) hints.push_back("Look here: " + causes.tone->hint);
  return hints;
}

/// Returns the losses of right programs that write JPEG, by pixel or block, wherever in pixels their samples are.
std::vector<double> LossesOfJpeg(const SceneImages& images, Encoding encoding) {
  const auto losses_of = [&](const R2::Image& image) {
    return LossesOf(images.Cells(Decoded(AsJpeg(Encoded(image, encoding)), encoding)), images.Cells(image));
  };
  std::vector<double> losses = losses_of(images.Reference());
  for (const R2::Image& corner : images.Corners()) {
    const std::vector<double> others = losses_of(corner);
    std::ranges::transform(losses, others, losses.begin(), [](double a, double b) { return std::max(a, b); });
  }
  return losses;
}

/// Returns a sentence about acne, if there is any.
std::optional<std::string> AcneRemark(double percent) {
  if (!(percent > 0)) return {};
  return "Shadow acne: single pixels (" + Plain(percent, 2) +
         "%) are too dark on lit, smooth surfaces. A shadow ray that starts on a surface hits it again by rounding; "
         "start it a little off the surface.";
}

/// Sets the outcome and the remarks of a scene that differs from the verdict on all scenes.
void ApplyTo(SceneResult& result, const Exhibit& exhibit, const Diagnosis& diagnosis, std::size_t i) {
  using enum Diagnosis::Kind;
  const bool has_cause = diagnosis.kind == named || diagnosis.kind == in_part;
  const bool is_known = has_cause && diagnosis.explains[i] && diagnosis.shown[i].Size() > 0;
  result.remarks.clear();
  result.note.clear();
  const auto terminator =
      is_known ? std::nullopt : TerminatorRemark(exhibit.student, exhibit.found, *exhibit.images);
  if (terminator) {
    result.remarks.push_back(*terminator);
    result.note = "terminator";
  } else if (const auto acne = AcneRemark(diagnosis.specks[i])) {
    result.remarks.push_back(*acne);
    result.note = "acne";
  }
  if (is_known) {
    result.outcome = Outcome::known_mistake;
    result.mistakes = diagnosis.shown[i].Names();
    result.explained = diagnosis.share;
    result.headline = Differing(result) + ", as with: " + diagnosis.shown[i].Titles() + ".";
  } else if (!diagnosis.explains[i] && result.note.empty()) {
    if (const auto empty = EmptyRemark(exhibit.student.image)) {
      result.remarks.push_back(*empty);
      result.note = "empty";
    } else if (const auto cracks = CrackRemark(exhibit.student, exhibit.found, *exhibit.images)) {
      result.remarks.push_back(*cracks);
      result.note = "cracks";
    } else {
      result.remarks.emplace_back(
          "No mistake that raygrade knows causes such an image. Begin with the pixel below: "
          "what do your rays do there?");
    }
  }
}

/// Returns the scene whose worst pixel differs most, among those that the causes explain.
std::string BestScene(std::span<const Exhibit> exhibits, const Diagnosis& diagnosis) {
  const Exhibit* best = nullptr;
  for (std::size_t i = 0; i < exhibits.size(); ++i)
    if (!exhibits[i].is_right && diagnosis.shown[i].Size() > 0 &&
        (diagnosis.explains[i] || diagnosis.kind == Diagnosis::Kind::resembles) &&
        (!best || exhibits[i].found.worst > best->found.worst))
      best = &exhibits[i];
  return best ? best->images->scene().name : "";
}

StudentVerdict VerdictOf(std::span<const Exhibit> exhibits, const Diagnosis& diagnosis) {
  StudentVerdict verdict;
  const bool is_right = std::ranges::all_of(exhibits, [](const Exhibit& exhibit) { return exhibit.is_right; });
  const std::string looks_like = "Looks most like: " + diagnosis.causes.Titles() + ". But that is not all of it: ";
  std::vector<std::string> shown_by, unexplained;
  for (std::size_t i = 0; i < exhibits.size(); ++i) {
    if (exhibits[i].is_right) continue;
    const std::string& name = exhibits[i].images->scene().name;
    if (!diagnosis.explains[i])
      unexplained.push_back(name);
    else if (diagnosis.shown[i].Size() > 0)
      shown_by.push_back(name);
  }
  switch (diagnosis.kind) {
    case Diagnosis::Kind::right:
      verdict.headline = is_right ? "All images are right." : "The only difference is shadow acne.";
      return verdict;
    case Diagnosis::Kind::named: {
      verdict.headline = "Cause: " + diagnosis.causes.Titles() + ".";
      verdict.mistakes = diagnosis.causes.Names();
      verdict.scenes = shown_by;
      verdict.best_scene = BestScene(exhibits, diagnosis);
      verdict.remarks = HintsOf(diagnosis.causes);
      std::vector<std::string> others;
      for (const Hypothesis& other : diagnosis.alternatives) others.push_back(other.Titles());
      if (!others.empty())
        verdict.remarks.push_back("In these scenes it looks the same as: " + JoinedWith(others, "; ") + ".");
      return verdict;
    }
    case Diagnosis::Kind::in_part:
      verdict.headline = looks_like + "it does not explain the difference in " + JoinedWith(unexplained, ", ") + ".";
      verdict.scenes = shown_by;
      verdict.best_scene = BestScene(exhibits, diagnosis);
      verdict.remarks = HintsOf(diagnosis.causes);
      return verdict;
    case Diagnosis::Kind::resembles:
      verdict.headline = looks_like + "it explains " + Percent(diagnosis.share) + " of the difference.";
      verdict.remarks = HintsOf(diagnosis.causes);
      verdict.best_scene = BestScene(exhibits, diagnosis);
      return verdict;
    case Diagnosis::Kind::unknown:
      verdict.headline = "No cause that raygrade knows explains the difference.";
      return verdict;
  }
  return verdict;
}

}  // namespace

Encoding EncodingOf(std::span<const HandedIn> handed_in) {
  // Surfaces that a mistake changes are right with neither encoding; backgrounds alone are often a third of an image.
  constexpr double least_right = 0.2, clearly = 0.15;  // of the steady pixels
  const auto right_with = [&](Encoding encoding) {
    double steady = 0, right = 0;
    for (const Exhibit& exhibit : ExhibitsOf(handed_in, encoding)) {
      steady += static_cast<double>(exhibit.found.steady);
      right += static_cast<double>(exhibit.found.steady - exhibit.found.differing);
    }
    return steady > 0 ? right / steady : 0;
  };
  const double linear = right_with(Encoding::linear);
  const double srgb = right_with(Encoding::srgb), power = right_with(Encoding::power);
  const double best = std::max(srgb, power);
  if (!(best > least_right && best > linear + clearly)) return Encoding::linear;
  return srgb >= power ? Encoding::srgb : Encoding::power;
}

std::vector<Exhibit> ExhibitsOf(std::span<const HandedIn> handed_in, Encoding encoding) {
  std::vector<Exhibit> exhibits;
  for (const HandedIn& one : handed_in) {
    std::vector<R2::Image> runs;
    for (const R2::Image& run : one.runs) runs.push_back(Decoded(run, encoding));
    const std::vector<double> losses = one.is_jpeg ? LossesOfJpeg(*one.images, encoding) : std::vector<double>();
    exhibits.push_back(MakeExhibit(*one.images, MakeSubmission(runs, *one.images, losses)));
  }
  return exhibits;
}

void JudgeAlone(const Exhibit& exhibit, const Suite& suite, SceneResult& result) {
  SceneImages& images = *exhibit.images;
  const Comparison& found = exhibit.found;
  result.percent = found.Percent();
  result.expected = images.Reference();
  result.actual = exhibit.student.image;
  result.difference = R2::SignedDifference(exhibit.student.image, images.Reference());
  result.worst_x = result.worst_y = -1;
  if (exhibit.is_right) {
    result.outcome = Outcome::right;
    result.headline = found.differing == 0 ? "The image is right."
                                           : "The image is right, except for " + Percent(result.percent / 100) +
                                                 " of its pixels, which is allowed.";
  } else {
    result.outcome = Outcome::different;
    result.headline = Differing(result) + ".";
    result.worst_x = found.worst_x, result.worst_y = found.worst_y;
    result.ray_tree = images.RayTreeAt(found.worst_x, found.worst_y);
  }
  result.score = ScoreOf(result, suite);
}

Findings JudgeTogether(std::span<const HandedIn> handed_in, const Suite& suite, StudentResult& student) {
  const Encoding encoding = EncodingOf(handed_in);
  std::vector<Exhibit> exhibits = ExhibitsOf(handed_in, encoding);
  std::vector<std::size_t> scenes;
  std::string of_empty;
  bool has_evidence = false;
  std::vector<Exhibit> kept;
  for (std::size_t i = 0; i < exhibits.size(); ++i) {
    SceneResult& result = student.scenes[handed_in[i].scene];
    JudgeAlone(exhibits[i], suite, result);
    // Images of one color are evidence only together with others: too many causes make them. Black ones never are.
    const R2::Image& image = exhibits[i].student.image;
    const auto remark = exhibits[i].is_right ? std::nullopt : EmptyRemark(image);
    if (remark) {
      result.remarks = {*remark};
      result.note = "empty";
      of_empty = *remark;
      if (IsBlack(image)) continue;
    }
    has_evidence |= !remark;
    scenes.push_back(handed_in[i].scene);
    kept.push_back(std::move(exhibits[i]));
  }
  StudentVerdict& verdict = student.verdict;
  if (!has_evidence) {
    verdict = {};
    verdict.headline = !of_empty.empty() ? of_empty : "There is no image to compare.";
    return {encoding, {}};
  }
  const Diagnosis diagnosis = Diagnose(kept);
  verdict = VerdictOf(kept, diagnosis);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    SceneResult& result = student.scenes[scenes[i]];
    if (!kept[i].is_right) ApplyTo(result, kept[i], diagnosis, i);
    result.score = ScoreOf(result, suite);
  }
  std::vector<std::string> with_acne, empty, failed;
  for (const SceneResult& result : student.scenes) {
    if (result.note == "acne") with_acne.push_back(result.scene);
    if (result.note == "empty") empty.push_back(result.scene);
    if (result.outcome == Outcome::failed) failed.push_back(result.scene);
  }
  if (diagnosis.kind == Diagnosis::Kind::right && !(empty.empty() && failed.empty()))
    verdict.headline = "All other images are right.";
  if (!with_acne.empty()) verdict.remarks.push_back("Shadow acne in: " + JoinedWith(with_acne, ", ") + ".");
  if (!empty.empty()) verdict.remarks.push_back("Of a single color: " + JoinedWith(empty, ", ") + ".");
  if (!failed.empty()) verdict.remarks.push_back("Without an image: " + JoinedWith(failed, ", ") + ".");
  if (encoding != Encoding::linear)
    verdict.remarks.push_back(std::string("The images are gamma encoded (") +
                              (encoding == Encoding::srgb ? "sRGB" : "power 1/2.2") +
                              "). This costs no points: it is undone before they are compared.");
  return {encoding, diagnosis};
}

}  // namespace ray::grade
