#include "grader/Diagnosis.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "R2/compare/Difference.h"
#include "grader/PixelShift.h"

namespace ray::grade {
namespace {

constexpr double most_cost = 2;  // of a scene

/// A hypothesis with its cost. A scene that it explains costs 0; one whose image is as far from the student's as the
/// reference is costs 1; one that contradicts it costs `most_cost`.
struct Scored {
  Hypothesis hypothesis;
  double cost = 0;
  double squares = 0;  // remaining in scenes that differ
};

bool IsBetter(const Scored& a, const Scored& b) {
  if (a.cost != b.cost) return a.cost < b.cost;
  return a.squares < b.squares;
}

bool Contains(const MistakeList& list, const Mistake* mistake) {
  return std::ranges::find(list, mistake) != list.end();
}

/// Returns true if mistakes change only the finished image. They may take its pixels apart, so that all are at edges.
bool AreOfImage(const MistakeList& mistakes) {
  return !mistakes.empty() && std::ranges::none_of(mistakes, [](const Mistake* mistake) { return mistake->make; });
}

class CauseSearch {
 public:
  explicit CauseSearch(std::span<const Exhibit> exhibits) : exhibits_(exhibits) {
    for (const Exhibit& exhibit : exhibits_) {
      const SceneImages& images = *exhibit.images;
      base_.push_back(FitOf(exhibit, images.Reference()).value_or(Fit{}));
      const R2::Image black(images.Reference().Width(), images.Reference().Height());
      // Otherwise a mistake that removes all light would be named for any dark image.
      const auto of_black = FitOf(exhibit, black);
      simplest_.push_back(of_black ? std::min(base_.back().squares, of_black->squares) : base_.back().squares);
    }
    order_.resize(exhibits_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    // Scenes with the largest difference first, since they reject most hypotheses.
    std::ranges::stable_sort(order_, [&](std::size_t a, std::size_t b) {
      if (exhibits_[a].is_right != exhibits_[b].is_right) return exhibits_[b].is_right;
      return base_[a].squares > base_[b].squares;
    });
  }

  Diagnosis Run() {
    const Scored nothing = Score({}, everything);
    if (nothing.cost == 0) return Found(nothing, {}, Diagnosis::Kind::right);
    std::vector<Scored> singles = Singles();
    if (singles.empty()) return Found(nothing, {}, Diagnosis::Kind::unknown);
    const std::vector<Scored> verified = Verified(singles, nothing.cost);
    if (!verified.empty()) {
      std::vector<Hypothesis> alternatives;
      for (std::size_t i = 1; i < verified.size(); ++i) alternatives.push_back(verified[i].hypothesis);
      return Found(verified[0], std::move(alternatives), Diagnosis::Kind::named);
    }
    return Concluded(Shortened(WithMore(singles, singles[0])));
  }

 private:
  static constexpr double everything = std::numeric_limits<double>::infinity();

  bool HasRightScene() const {
    return std::ranges::any_of(exhibits_, [](const Exhibit& exhibit) { return exhibit.is_right; });
  }
  /// The treatment of edges. Quick fits accept a value between those of neighbors. Strict ones accept the change of the
  /// image with mistakes within a pixel, which takes four more images.
  enum class Care { quick, strict };

  /// Returns true if the remaining difference in a scene is that of rounding and of another program's edges.
  bool IsWhole(std::size_t scene, const Fit& fit, Care care) const {
    const SceneImages& images = *exhibits_[scene].images;
    const double allowed = images.scene().allowed;
    const auto& [squares, percent, specks] = base_[scene];
    if (fit.percent <= allowed) return true;
    if (care == Care::strict && images.CellSide() == 1)
      return fit.squares <= (1 - least_share) * squares && !Contradicts(scene, fit);
    // Measured with a camera shifted by a tenth of a pixel: mistakes that move objects slightly leave 7% of the
    // squares, at edges, on 4% of the pixels that differ. Those that change much leave 2% of the squares.
    constexpr double most_pixels_left = 0.15, few_pixels_left = 0.1, most_at_edges = 0.1;
    if (fit.squares <= (1 - least_share) * squares)
      return fit.percent <= std::max(most_pixels_left * percent, 2 * allowed);
    return fit.squares <= most_at_edges * squares && fit.percent <= std::min(few_pixels_left * percent, 2 * allowed);
  }
  bool Contradicts(std::size_t scene, const Fit& fit) const {
    return fit.percent > 2 * exhibits_[scene].images->scene().allowed;
  }
  double CostOf(std::size_t scene, const std::optional<Fit>& fit, Care care) const {
    constexpr double least = 0.05;  // of the unexplained difference
    if (exhibits_[scene].is_right) return fit && Contradicts(scene, *fit) ? most_cost : 0;
    if (!fit) return 1;
    if (IsWhole(scene, *fit, care)) return 0;
    return base_[scene].squares > 0 ? std::clamp(fit->squares / base_[scene].squares, least, most_cost) : 1;
  }

  std::optional<Fit> FitWith(std::size_t scene, const Hypothesis& hypothesis, Care care = Care::quick) const {
    SceneImages& images = *exhibits_[scene].images;
    const R2::Image image = ImageWith(images, hypothesis);
    if ((care == Care::quick && !AreOfImage(hypothesis.mistakes)) || images.CellSide() > 1)
      return FitOf(exhibits_[scene], image);
    const std::vector<double> spread = images.SpreadWith(hypothesis.mistakes);
    return FitOf(exhibits_[scene], image, &spread);
  }
  /// Returns the hypothesis with its cost. Ends early if the cost exceeds `bound`; the exact cost is then unknown.
  Scored Score(const Hypothesis& hypothesis, double bound, Care care = Care::quick) const {
    Scored scored{hypothesis, 0, 0};
    for (const std::size_t scene : order_) {
      const auto fit = FitWith(scene, hypothesis, care);
      scored.cost += CostOf(scene, fit, care);
      if (!exhibits_[scene].is_right) scored.squares += fit ? fit->squares : base_[scene].squares;
      if (scored.cost > bound) break;
    }
    return scored;
  }

  /// Returns the simple changes that fit the images with these mistakes best. Empty if a scene is right, since they
  /// change all.
  std::vector<Tone> TonesBehind(const MistakeList& mistakes) const {
    if (HasRightScene()) return {};
    std::vector<R2::Image> lights;
    std::vector<TonePair> pairs;
    lights.reserve(exhibits_.size());
    for (const Exhibit& exhibit : exhibits_) {
      if (exhibit.images->CellSide() > 1) continue;
      auto light = exhibit.images->LightWith(mistakes);
      if (!light) continue;
      lights.push_back(std::move(*light));
      pairs.push_back({exhibit.student.image, lights.back(), exhibit.images->Steady()});
    }
    return FittedTones(pairs);
  }

  std::vector<Scored> Singles() {
    std::vector<Scored> singles;
    for (const Tone& tone : TonesBehind({})) {
      const Scored scored = Score({{}, tone}, everything);
      singles.push_back(scored);
      for (std::size_t scene = 0; scene < exhibits_.size(); ++scene)
        if (const auto fit = FitWith(scene, scored.hypothesis))
          simplest_[scene] = std::min(simplest_[scene], fit->squares);
    }
    const double unexplained = Score({}, everything).cost;
    for (const Mistake* mistake : Mistakes()) {
      Scored scored = Score({{mistake}, {}}, unexplained);
      if (scored.cost <= unexplained) singles.push_back(std::move(scored));
    }
    std::ranges::stable_sort(singles, IsBetter);
    return singles;
  }

  /// Returns the squares that count as equal: a hundredth of the difference, or the remainder of a few pixels at edges.
  double AsGood() const {
    double all = 0, pixels = 0;
    for (std::size_t i = 0; i < base_.size(); ++i) {
      if (exhibits_[i].is_right) continue;
      all += base_[i].squares;
      pixels += static_cast<double>(exhibits_[i].found.steady);
    }
    constexpr double hundredth = 0.01, of_a_pixel = 1e-4;
    return std::max(hundredth * all, of_a_pixel * pixels);
  }
  /// Returns the single causes that explain all scenes in a strict comparison: the best first, and equally good ones.
  /// Among these, a change of the finished image comes first. If there are none, those that seemed to explain all get
  /// the cost of a strict comparison.
  std::vector<Scored> Verified(std::vector<Scored>& singles, double unexplained) const {
    constexpr std::size_t most = 8;
    constexpr double hopeful = 0.5;  // of the cost without any cause
    std::vector<Scored> verified;
    for (std::size_t i = 0; i < std::min(most, singles.size()) && singles[i].cost <= hopeful * unexplained; ++i) {
      const bool seems_whole = singles[i].cost == 0;
      Scored scored = Score(singles[i].hypothesis, seems_whole ? everything : 0, Care::strict);
      if (scored.cost == 0)
        verified.push_back(std::move(scored));
      else if (seems_whole)
        singles[i] = std::move(scored);
    }
    if (verified.empty()) {
      std::ranges::stable_sort(singles, IsBetter);
      return verified;
    }
    std::ranges::stable_sort(verified, IsBetter);
    const double enough = verified[0].squares + AsGood();
    std::erase_if(verified, [&](const Scored& one) { return one.squares > enough; });
    const auto rank = [](const Scored& one) {
      if (one.hypothesis.tone) return one.hypothesis.tone->free_numbers > 1 ? 2 : 0;
      return one.hypothesis.mistakes[0]->of_image ? 0 : 1;
    };
    std::ranges::stable_sort(verified, [&](const Scored& a, const Scored& b) { return rank(a) < rank(b); });
    return verified;
  }

  /// Returns true if a mistake alone changes a scene that is right.
  bool IsExcluded(const Mistake* mistake) const {
    return std::ranges::any_of(exhibits_, [&](const Exhibit& exhibit) {
      return exhibit.is_right && PercentChanged(*exhibit.images, {mistake}) > 4 * exhibit.images->scene().allowed;
    });
  }
  /// The scene with the highest cost of a hypothesis, and its differing pixels.
  struct Left {
    std::size_t scene;
    std::vector<bool> differs;
    std::int64_t count;
  };
  /// Returns std::nullopt if mistakes move pixels, so that those of further mistakes would be elsewhere.
  std::optional<Left> LeftBy(const Hypothesis& hypothesis) const {
    if (hypothesis.tone || std::ranges::any_of(hypothesis.mistakes, [](const Mistake* one) { return !one->make; }))
      return {};
    std::size_t worst = order_[0];
    double most = 0;
    for (const std::size_t scene : order_)
      if (const double cost = CostOf(scene, FitWith(scene, hypothesis), Care::quick); cost > most)
        most = cost, worst = scene;
    SceneImages& images = *exhibits_[worst].images;
    Comparison found = Compare(exhibits_[worst].student, images.Cells(ImageWith(images, hypothesis)), images);
    return Left{worst, std::move(found.differs), found.differing};
  }
  /// Returns false if a mistake alone leaves most of these pixels unchanged. Then it explains none of them after
  /// another one, so its image need not be rendered.
  bool MayExplain(const Mistake& mistake, const Left& left) const {
    constexpr double enough = 0.3;
    if (!mistake.make) return true;
    SceneImages& images = *exhibits_[left.scene].images;
    const auto made = images.With({&mistake});
    if (!made) return false;
    const Comparison changed = Compare(MakeSubmission({*made}, images), images);
    std::int64_t both = 0;
    for (std::size_t i = 0; i < left.differs.size(); ++i) both += left.differs[i] && changed.differs[i];
    return static_cast<double>(both) > enough * static_cast<double>(left.count);
  }
  /// Returns the best of `begin` followed by one more cause, if it costs less than `best`, or if both cost nothing and
  /// it leaves less.
  Scored Extended(const Hypothesis& begin, const std::vector<const Mistake*>& more, Scored best) const {
    constexpr double noticeably = 0.05;
    const auto left = LeftBy(begin);
    for (const Mistake* mistake : more) {
      if (Contains(begin.mistakes, mistake) || (left && !MayExplain(*mistake, *left))) continue;
      Hypothesis longer = begin;
      longer.mistakes.push_back(mistake);
      const double bound = std::max(0.0, best.cost - noticeably);
      Scored scored = Score(longer, bound);
      const bool is_whole = scored.cost == 0 && best.hypothesis.Size() == longer.Size()
                                ? IsBetter(scored, best)
                                : scored.cost == 0 && best.cost > 0;
      if (scored.cost < bound || is_whole) best = std::move(scored);
    }
    return best;
  }
  Scored WithMore(const std::vector<Scored>& singles, Scored best) const {
    constexpr std::size_t firsts = 10, most_causes = 4;
    constexpr double hopeless = 0.95;  // of what no cause at all costs
    constexpr double worthwhile = 0.3;  // of a scene, that each further cause must explain
    std::vector<const Mistake*> possible;
    std::ranges::copy_if(Mistakes(), std::back_inserter(possible),
                         [&](const Mistake* one) { return !IsExcluded(one); });
    const double of_single = best.cost;
    const double unexplained = Score({}, everything).cost;
    for (std::size_t i = 0; i < std::min(firsts, singles.size()) && singles[i].cost < hopeless * unexplained; ++i)
      best = Extended(singles[i].hypothesis, possible, std::move(best));
    if (best.cost > 0) best = WithTones(possible, std::move(best));
    if (best.hypothesis.Size() == 2 && best.cost > 0 && !best.hypothesis.tone) {
      // The second was chosen for the first, which may itself have stood for another mistake.
      const Hypothesis second{{best.hypothesis.mistakes[1]}, {}};
      best = Extended(second, possible, std::move(best));
    }
    if (best.cost > of_single - worthwhile * 0.5 && best.cost > 0) return singles[0];
    while (best.cost > 0 && best.hypothesis.Size() >= 2 && best.hypothesis.Size() < most_causes) {
      const Hypothesis begin = best.hypothesis;
      Scored longer = Extended(begin, possible, best);
      if (longer.cost > best.cost - worthwhile) break;
      best = std::move(longer);
    }
    return best;
  }
  /// Tries mistakes followed by a simple change of the image.
  Scored WithTones(const std::vector<const Mistake*>& possible, Scored best) const {
    if (HasRightScene()) return best;
    for (const Mistake* mistake : possible)
      for (const Tone& tone : TonesBehind({mistake})) {
        if (tone.free_numbers != 1) continue;
        Scored scored = Score({{mistake}, tone}, best.cost);
        if (scored.cost < best.cost) best = std::move(scored);
        if (best.cost == 0) return best;
      }
    return best;
  }

  static Hypothesis Without(const Hypothesis& hypothesis, std::size_t which) {
    Hypothesis shorter = hypothesis;
    if (which < shorter.mistakes.size())
      shorter.mistakes.erase(shorter.mistakes.begin() + static_cast<std::ptrdiff_t>(which));
    else
      shorter.tone.reset();
    return shorter;
  }
  /// Returns true if the images of a scene with these causes differ visibly.
  static bool Changes(SceneImages& images, const Hypothesis& a, const Hypothesis& b) {
    const Submission student = MakeSubmission({ImageWith(images, a)}, images);
    return Compare(student, images.Cells(ImageWith(images, b)), images).Percent() > images.scene().allowed;
  }
  /// Removes causes that explain nothing.
  Scored Shortened(Scored best) const {
    constexpr double nothing = 0.02;
    const Care care = best.cost == 0 ? Care::strict : Care::quick;
    if (care == Care::strict) best = Score(best.hypothesis, everything, care);
    for (std::size_t i = 0; i < best.hypothesis.Size() && best.hypothesis.Size() > 1;) {
      Scored shorter = Score(Without(best.hypothesis, i), best.cost + nothing, care);
      if (shorter.cost <= best.cost + nothing)
        best = std::move(shorter);
      else
        ++i;
    }
    return best;
  }

  /// Returns true if each cause explains the whole difference in every scene that it changes, and is required for that
  /// in at least one.
  bool IsEstablished(const Hypothesis& hypothesis) const {
    for (std::size_t i = 0; i < hypothesis.Size(); ++i) {
      const Hypothesis shorter = Without(hypothesis, i);
      int changed = 0, explained = 0;
      bool is_needed = false;
      for (std::size_t scene = 0; scene < exhibits_.size(); ++scene) {
        const Exhibit& exhibit = exhibits_[scene];
        SceneImages& images = *exhibit.images;
        if (!Changes(images, hypothesis, shorter)) continue;
        const auto fit = FitWith(scene, hypothesis, Care::strict), fit_without = FitWith(scene, shorter, Care::strict);
        if (exhibit.is_right && fit && Contradicts(scene, *fit)) return false;
        ++changed;
        if (!fit || !IsWhole(scene, *fit, Care::strict)) continue;
        ++explained;
        is_needed |= !fit_without || !IsWhole(scene, *fit_without, Care::strict);
      }
      if (!is_needed || explained < changed) return false;
    }
    return true;
  }
  /// Returns the explained share of the squared difference, or of its remainder after the best simple change.
  double ShareOf(const Scored& best) const {
    double all = 0;
    for (std::size_t i = 0; i < exhibits_.size(); ++i)
      if (!exhibits_[i].is_right) all += best.hypothesis.tone ? base_[i].squares : simplest_[i];
    return all > 0 ? 1 - best.squares / all : 0;
  }
  Diagnosis Concluded(const Scored& best) const {
    constexpr double most_of_it = 0.8;
    using enum Diagnosis::Kind;
    const bool is_whole = best.cost == 0 && Score(best.hypothesis, 0, Care::strict).cost == 0;
    return Found(best, {},
                 is_whole                         ? named
                 : IsEstablished(best.hypothesis) ? in_part
                 : ShareOf(best) > most_of_it     ? resembles
                                                  : unknown);
  }
  Diagnosis Found(const Scored& best, std::vector<Hypothesis> alternatives, Diagnosis::Kind kind) const {
    Diagnosis found{kind, best.hypothesis, std::move(alternatives), ShareOf(best), {}, {}, {}};
    for (std::size_t scene = 0; scene < exhibits_.size(); ++scene) {
      SceneImages& images = *exhibits_[scene].images;
      const auto fit = FitWith(scene, best.hypothesis, Care::strict);
      found.explains.push_back(fit && IsWhole(scene, *fit, Care::strict));
      found.specks.push_back(exhibits_[scene].is_right || !fit ? 0 : fit->specks);
      Hypothesis shown = best.hypothesis;
      for (std::size_t i = best.hypothesis.Size(); i-- > 0;)
        if (!Changes(images, best.hypothesis, Without(best.hypothesis, i))) shown = Without(shown, i);
      found.shown.push_back(std::move(shown));
    }
    return found;
  }

  std::span<const Exhibit> exhibits_;
  std::vector<std::size_t> order_;
  std::vector<Fit> base_;         // without any cause
  std::vector<double> simplest_;  // remaining squares after the best simple change
};

}  // namespace

std::string Hypothesis::Names() const {
  std::string names;
  for (const Mistake* mistake : mistakes) names += (names.empty() ? "" : "+") + std::string(mistake->name);
  if (tone) names += (names.empty() ? "" : "+") + tone->name;
  return names;
}

std::string Hypothesis::Titles() const {
  std::string titles;
  for (const Mistake* mistake : mistakes) titles += (titles.empty() ? "" : ", and ") + std::string(mistake->title);
  if (tone) titles += (titles.empty() ? "" : ", and ") + tone->title;
  return titles;
}

R2::Image ImageWith(SceneImages& images, const Hypothesis& hypothesis) {
  auto light = images.LightWith(hypothesis.mistakes);
  if (!light) light = images.LightWith({});
  return hypothesis.tone ? Toned(*light, *hypothesis.tone) : R2::Displayed(*light, R2::Display::straight);
}

Diagnosis Diagnose(std::span<const Exhibit> exhibits) { return CauseSearch(exhibits).Run(); }

double PercentChanged(SceneImages& images, const MistakeList& mistakes) {
  const auto made = images.With(mistakes);
  if (!made) return 0;
  return Compare(MakeSubmission({*made}, images), images).Percent();
}

bool IsVisible(SceneImages& images, const MistakeList& mistakes) {
  return PercentChanged(images, mistakes) > images.scene().allowed;
}

}  // namespace ray::grade
