#include "grader/Comparison.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "grader/JpegTolerance.h"

namespace ray::grade {
namespace {

double Square(double number) { return number * number; }

std::size_t IndexOf(const R2::Image& image, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.Width()) + static_cast<std::size_t>(x);
}

/// Three standard deviations of the mean of the runs, of each cell.
std::vector<double> NoiseOf(const std::vector<R2::Image>& runs, const R2::Image& mean, const SceneImages& images) {
  std::vector<double> noise(images.Cells(mean).Channels().size() / 3, 0.0);
  if (runs.size() < 2) return noise;
  const R2::Image middle = images.Cells(mean);
  for (const R2::Image& run : runs) {
    const R2::Image cells = images.Cells(run);
    for (int y = 0; y < cells.Height(); ++y)
      for (int x = 0; x < cells.Width(); ++x)
        noise[IndexOf(cells, x, y)] += Square(LargestChannel(cells.At(x, y) - middle.At(x, y)));
  }
  const auto count = static_cast<double>(runs.size());
  for (double& each : noise) each = 3 * std::sqrt(each / (count * (count - 1)));
  return noise;
}

R2::Image MeanOfRuns(const std::vector<R2::Image>& runs) {
  R2::Image mean(runs[0].Width(), runs[0].Height());
  for (int y = 0; y < mean.Height(); ++y)
    for (int x = 0; x < mean.Width(); ++x) {
      R2::Color sum;
      for (const R2::Image& run : runs) sum += run.At(x, y);
      mean.Set(x, y, sum / static_cast<double>(runs.size()));
    }
  return mean;
}

/// Squared differences beyond what rounding to bytes makes.
class Misfit {
 public:
  Misfit(const Submission& student, const SceneImages& images)
      : student_(student), images_(images), reference_(images.Cells(images.Reference())) {}

  /// Over steady pixels. Of an image with a mistake, pixels beside its own edges are left out, and the rest count for
  /// them: where exactly these edges lie is rounding. Nothing where too little is left.
  std::optional<double> Of(const R2::Image& image) const {
    const R2::Image cells = images_.Cells(image);
    double sum = 0, counted = 0, steady = 0;
    for (int y = 0; y < cells.Height(); ++y)
      for (int x = 0; x < cells.Width(); ++x) {
        if (!IsSteady(cells, x, y)) continue;
        ++steady;
        if (!IsCalm(cells, x, y)) continue;
        ++counted;
        sum += SquareAt(cells, x, y);
      }
    constexpr double enough = 0.4;  // of the steady pixels: fewer would be taken for the others without being like them
    if (!(counted > enough * steady)) return {};
    return sum * steady / counted;
  }

  /// What there is to explain: the difference to the reference, or to a black image if that is less. Else a mistake
  /// that takes all light away would be named for whatever is dark.
  double ToExplain() const {
    const R2::Image& reference = images_.Reference();
    const double of_reference = Of(reference).value_or(0);
    const double of_black = Of(R2::Image(reference.Width(), reference.Height())).value_or(0);
    return of_black > 0 ? std::min(of_reference, of_black) : of_reference;
  }

 private:
  bool IsSteady(const R2::Image& cells, int x, int y) const {
    return images_.CellSide() > 1 || images_.Steady()[IndexOf(cells, x, y)];
  }
  double SquareAt(const R2::Image& cells, int x, int y) const {
    constexpr double rounding = 1.5 / 255;
    const std::size_t i = IndexOf(cells, x, y);
    const double noise = student_.tolerance[i] - images_.scene().tolerance;
    const R2::Color d = cells.At(x, y) - student_.cells.At(x, y);
    const auto beyond = [&](double channel) { return std::max(0.0, std::abs(channel) - rounding - noise); };
    return Square(beyond(d.r)) + Square(beyond(d.g)) + Square(beyond(d.b));
  }
  bool IsCalm(const R2::Image& cells, int x, int y) const {
    constexpr double calm = 0.08;  // four of the usual tolerances: shading does not change by that from pixel to pixel
    if (images_.CellSide() > 1) return true;
    const R2::Color c = cells.At(x, y);
    if (LargestChannel(c - reference_.At(x, y)) < calm) return true;
    for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
      const int i = std::clamp(x + dx, 0, cells.Width() - 1), j = std::clamp(y + dy, 0, cells.Height() - 1);
      if (LargestChannel(cells.At(i, j) - c) > calm) return false;
    }
    return true;
  }

  const Submission& student_;
  const SceneImages& images_;
  R2::Image reference_;
};

///   all   misfit.ToExplain(); here and below
std::optional<double> ShareWith(const Misfit& misfit, double all, SceneImages& images, const MistakeList& mistakes) {
  const auto made = images.With(mistakes);
  if (!made || !(all > 0)) return {};
  const auto left = misfit.Of(*made);
  if (!left) return {};
  return 1 - *left / all;
}

struct Candidate {
  MistakeList mistakes;
  double share;
};

/// Mistakes of a finished image alone cost no rendering.
enum class Behind { every, of_image };

/// Every mistake that is tried behind those of `before`, the best first.
std::vector<Candidate> Ranked(const Misfit& misfit, double all, SceneImages& images, const MistakeList& before,
                              Behind tried = Behind::every) {
  std::vector<Candidate> candidates;
  for (const Mistake* mistake : Mistakes()) {
    if (tried == Behind::of_image && mistake->make) continue;
    if (std::ranges::find(before, mistake) != before.end()) continue;
    MistakeList mistakes = before;
    mistakes.push_back(mistake);
    if (const auto share = ShareWith(misfit, all, images, mistakes)) candidates.push_back({mistakes, *share});
  }
  std::ranges::stable_sort(candidates, std::greater(), &Candidate::share);
  return candidates;
}

MistakeList Alternatives(const std::vector<Candidate>& ranked) {
  constexpr double as_good = 0.005;  // of the difference: what bytes and a shifted camera leave of equal images
  MistakeList others;
  for (std::size_t i = 1; i < ranked.size() && ranked[i].share > ranked[0].share - as_good; ++i)
    others.push_back(ranked[i].mistakes.back());
  return others;
}

}  // namespace

Submission MakeSubmission(const std::vector<R2::Image>& runs, bool is_jpeg, const SceneImages& images) {
  Submission student{.image = MeanOfRuns(runs), .cells = {}, .tolerance = {}};
  student.cells = images.Cells(student.image);
  student.tolerance = NoiseOf(runs, student.image, images);
  for (double& each : student.tolerance) each += images.scene().tolerance;
  if (images.CellSide() == 1)
    for (std::size_t i = 0; i < student.tolerance.size(); ++i) student.tolerance[i] += images.Smoothing()[i];
  if (!is_jpeg) return student;
  const R2::Image reference = images.Cells(images.Reference()), compressed = images.Cells(AsJpeg(images.Reference()));
  for (int y = 0; y < reference.Height(); ++y)
    for (int x = 0; x < reference.Width(); ++x)
      student.tolerance[IndexOf(reference, x, y)] += LargestAround(reference, compressed, x, y);
  return student;
}

Comparison Compare(const Submission& student, const SceneImages& images) {
  const R2::Image reference = images.Cells(images.Reference());
  Comparison found;
  found.differs.assign(student.tolerance.size(), false);
  std::vector<double> differences(student.tolerance.size(), 0.0);
  for (int y = 0; y < reference.Height(); ++y)
    for (int x = 0; x < reference.Width(); ++x) {
      const std::size_t i = IndexOf(reference, x, y);
      if (images.CellSide() == 1 && !images.Steady()[i]) continue;
      const double difference = LargestChannel(student.cells.At(x, y) - reference.At(x, y));
      ++found.steady;
      if (!(difference > student.tolerance[i])) continue;
      ++found.differing;
      found.differs[i] = true;
      differences[i] = difference;
    }
  double most = 0;
  for (int y = 0; y < reference.Height(); ++y)
    for (int x = 0; x < reference.Width(); ++x) {
      if (!found.differs[IndexOf(reference, x, y)]) continue;
      double around = 0;
      for (int j = std::max(0, y - 2); j <= std::min(reference.Height() - 1, y + 2); ++j)
        for (int i = std::max(0, x - 2); i <= std::min(reference.Width() - 1, x + 2); ++i)
          around += differences[IndexOf(reference, i, j)];
      if (around > most) most = around, found.worst_x = x, found.worst_y = y;
    }
  found.worst_x = std::min(found.worst_x * images.CellSide() + images.CellSide() / 2, images.Reference().Width() - 1);
  found.worst_y = std::min(found.worst_y * images.CellSide() + images.CellSide() / 2, images.Reference().Height() - 1);
  return found;
}

std::optional<double> ShareExplained(const Submission& student, SceneImages& images, const MistakeList& mistakes) {
  const Misfit misfit(student, images);
  return ShareWith(misfit, misfit.ToExplain(), images, mistakes);
}

bool IsVisible(SceneImages& images, const MistakeList& mistakes) {
  const auto made = images.With(mistakes);
  if (!made) return false;
  const Submission student = MakeSubmission({*made}, false, images);
  return Compare(student, images).Percent() > images.scene().allowed;
}

Explanation Explain(const Submission& student, SceneImages& images) {
  constexpr double nearly_all = 0.995, most_left_by_second = 0.4;
  constexpr std::size_t firsts = 3;  // that are tried with every other
  // Among hundreds of pairs some fit by chance, so that those which do not begin with a likely mistake must fit better.
  constexpr double named_above_by_search = 0.95;
  const Misfit misfit(student, images);
  const double all = misfit.ToExplain();
  const std::vector<Candidate> singles = Ranked(misfit, all, images, {});
  if (singles.empty()) return {};
  const Candidate& best = singles[0];
  Explanation found{.mistakes = best.mistakes, .alternatives = Alternatives(singles), .share = best.share};
  if (best.share > nearly_all) return found;
  for (std::size_t i = 0; i < singles.size(); ++i) {
    const bool is_likely = i < firsts && singles[i].share > 0;
    const std::vector<Candidate> pairs =
        Ranked(misfit, all, images, singles[i].mistakes, is_likely ? Behind::every : Behind::of_image);
    if (pairs.empty() || pairs[0].share <= std::max(found.share, is_likely ? 0 : named_above_by_search)) continue;
    const bool is_worth_naming = 1 - pairs[0].share < most_left_by_second * (1 - best.share);
    if (!is_worth_naming) continue;
    found = {.mistakes = pairs[0].mistakes, .alternatives = {}, .share = pairs[0].share};
  }
  if (found.mistakes.size() == 2 && found.share < nearly_all) {
    // The second was chosen for the first, which may itself have stood for another mistake.
    const std::vector<Candidate> pairs = Ranked(misfit, all, images, {found.mistakes[1]});
    if (!pairs.empty() && pairs[0].share > found.share)
      found.mistakes = pairs[0].mistakes, found.share = pairs[0].share;
  }
  if (found.share > named_above) return found;
  return {.mistakes = {}, .alternatives = {}, .share = found.share};
}

}  // namespace ray::grade
