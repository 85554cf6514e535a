#include "grader/Diagnosis.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "R2/compare/Difference.h"
#include "grader/PixelShift.h"

namespace ray::grade {
namespace {

constexpr double most_cost = 2;  // of a scene

/// A hypothesis, and how badly it fits: a scene that is explained costs nothing, one that is as far from the student's
/// image as the reference is costs 1, one that contradicts it costs `most_cost`.
struct Scored {
  Hypothesis hypothesis;
  double cost = 0;
  double squares = 0;  // that are left in scenes that differ
};

bool IsBetter(const Scored& a, const Scored& b) {
  if (a.cost != b.cost) return a.cost < b.cost;
  return a.squares < b.squares;
}

bool Contains(const MistakeList& list, const Mistake* mistake) {
  return std::ranges::find(list, mistake) != list.end();
}

class CauseSearch {
 public:
  explicit CauseSearch(std::span<const Exhibit> exhibits) : exhibits_(exhibits) {
    for (const Exhibit& exhibit : exhibits_) {
      const SceneImages& images = *exhibit.images;
      base_.push_back(FitOf(exhibit, images.Reference()).value_or(Fit{}));
      const R2::Image black(images.Reference().Width(), images.Reference().Height());
      // Else a mistake that takes all light away would be named for whatever is dark.
      const auto of_black = FitOf(exhibit, black);
      simplest_.push_back(of_black ? std::min(base_.back().squares, of_black->squares) : base_.back().squares);
    }
    order_.resize(exhibits_.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    // What differs most rejects most.
    std::ranges::stable_sort(order_, [&](std::size_t a, std::size_t b) {
      if (exhibits_[a].is_right != exhibits_[b].is_right) return exhibits_[b].is_right;
      return base_[a].squares > base_[b].squares;
    });
  }

  Diagnosis Run() {
    const Scored nothing = Score({}, everything);
    if (nothing.cost == 0) return Found(nothing, {}, Diagnosis::Kind::right);
    const std::vector<Scored> singles = Singles();
    if (singles.empty()) return Found(nothing, {}, Diagnosis::Kind::unknown);
    Scored best = singles[0];
    if (best.cost > 0) best = WithMore(singles, best);
    return Concluded(Shortened(std::move(best)), singles);
  }

 private:
  static constexpr double everything = std::numeric_limits<double>::infinity();

  bool HasRightScene() const {
    return std::ranges::any_of(exhibits_, [](const Exhibit& exhibit) { return exhibit.is_right; });
  }
  bool IsWhole(std::size_t scene, const Fit& fit) const {
    constexpr double most_pixels_left = 0.15;  // of those that differ: edges of what a mistake moves
    if (fit.percent <= exhibits_[scene].images->scene().allowed) return true;
    return fit.squares <= (1 - least_share) * base_[scene].squares &&
           fit.percent <= most_pixels_left * base_[scene].percent;
  }
  bool Contradicts(std::size_t scene, const Fit& fit) const {
    return fit.percent > 2 * exhibits_[scene].images->scene().allowed;
  }
  double CostOf(std::size_t scene, const std::optional<Fit>& fit) const {
    constexpr double least = 0.05;  // of what is not explained
    if (exhibits_[scene].is_right) return fit && Contradicts(scene, *fit) ? most_cost : 0;
    if (!fit) return 1;
    if (IsWhole(scene, *fit)) return 0;
    return base_[scene].squares > 0 ? std::clamp(fit->squares / base_[scene].squares, least, most_cost) : 1;
  }
  std::optional<Fit> FitWith(std::size_t scene, const Hypothesis& hypothesis) const {
    return FitOf(exhibits_[scene], ImageWith(*exhibits_[scene].images, hypothesis));
  }
  /// Ends early where the cost exceeds `bound`, and is then only known to do so.
  Scored Score(const Hypothesis& hypothesis, double bound) const {
    Scored scored{hypothesis, 0, 0};
    for (const std::size_t scene : order_) {
      const auto fit = FitWith(scene, hypothesis);
      scored.cost += CostOf(scene, fit);
      if (!exhibits_[scene].is_right) scored.squares += fit ? fit->squares : base_[scene].squares;
      if (scored.cost > bound) break;
    }
    return scored;
  }

  /// Simple changes that fit the images with these mistakes best. None if a scene is right, since they change all.
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
    PreferSimple(singles);
    return singles;
  }

  /// What is left beyond doubt: a hundredth of what there is to explain.
  double AsGood() const {
    double all = 0;
    for (std::size_t i = 0; i < base_.size(); ++i)
      if (!exhibits_[i].is_right) all += base_[i].squares;
    constexpr double hundredth = 0.01;
    return hundredth * all;
  }
  /// Of causes that explain all of it equally well, a change of the finished image comes first.
  void PreferSimple(std::vector<Scored>& singles) const {
    if (singles.empty() || singles[0].cost > 0) return;
    const double most = singles[0].squares + AsGood();
    const auto rank = [&](const Scored& one) {
      if (one.cost > 0 || one.squares > most) return 3;
      if (one.hypothesis.tone) return one.hypothesis.tone->free_numbers > 1 ? 2 : 0;
      return one.hypothesis.mistakes[0]->of_image ? 0 : 1;
    };
    std::ranges::stable_sort(singles, [&](const Scored& a, const Scored& b) { return rank(a) < rank(b); });
  }

  /// True if a mistake alone changes a scene that is right.
  bool IsExcluded(const Mistake* mistake) const {
    return std::ranges::any_of(exhibits_, [&](const Exhibit& exhibit) {
      return exhibit.is_right && PercentChanged(*exhibit.images, {mistake}) > 4 * exhibit.images->scene().allowed;
    });
  }
  /// The best of `begin` with one more cause behind it, if that costs less than `best`, or nothing either
  /// and leaves less.
  Scored Extended(const Hypothesis& begin, const std::vector<const Mistake*>& more, Scored best) const {
    constexpr double noticeably = 0.05;
    for (const Mistake* mistake : more) {
      if (Contains(begin.mistakes, mistake)) continue;
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
    constexpr std::size_t firsts = 8, most_causes = 4;
    constexpr double worthwhile = 0.3;  // of a scene, that each further cause must explain
    std::vector<const Mistake*> possible;
    std::ranges::copy_if(Mistakes(), std::back_inserter(possible),
                         [&](const Mistake* one) { return !IsExcluded(one); });
    const double of_single = best.cost;
    for (std::size_t i = 0; i < std::min(firsts, singles.size()); ++i)
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
  /// Mistakes with a simple change of the image behind them.
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
  /// True if the images of a scene with these causes differ visibly.
  static bool Changes(SceneImages& images, const Hypothesis& a, const Hypothesis& b) {
    const Submission student = MakeSubmission({ImageWith(images, a)}, false, images);
    return Compare(student, images.Cells(ImageWith(images, b)), images).Percent() > images.scene().allowed;
  }
  /// Leaves out causes that explain nothing.
  Scored Shortened(Scored best) const {
    constexpr double nothing = 0.02;
    for (std::size_t i = 0; i < best.hypothesis.Size() && best.hypothesis.Size() > 1;) {
      Scored shorter = Score(Without(best.hypothesis, i), best.cost + nothing);
      if (shorter.cost <= best.cost + nothing)
        best = std::move(shorter);
      else
        ++i;
    }
    return best;
  }

  /// True if each cause explains all that differs in every scene that it changes, and in one of them not without it.
  bool IsEstablished(const Hypothesis& hypothesis) const {
    for (std::size_t i = 0; i < hypothesis.Size(); ++i) {
      const Hypothesis shorter = Without(hypothesis, i);
      int changed = 0, explained = 0;
      bool is_needed = false;
      for (std::size_t scene = 0; scene < exhibits_.size(); ++scene) {
        const Exhibit& exhibit = exhibits_[scene];
        SceneImages& images = *exhibit.images;
        if (!Changes(images, hypothesis, shorter)) continue;
        const auto fit = FitWith(scene, hypothesis), fit_without = FitWith(scene, shorter);
        if (exhibit.is_right && fit && Contradicts(scene, *fit)) return false;
        ++changed;
        if (!fit || !IsWhole(scene, *fit)) continue;
        ++explained;
        is_needed |= !fit_without || !IsWhole(scene, *fit_without);
      }
      if (!is_needed || explained < changed) return false;
    }
    return true;
  }
  /// Of the squared difference, or of what the best simple change leaves of it.
  double ShareOf(const Scored& best) const {
    double all = 0;
    for (std::size_t i = 0; i < exhibits_.size(); ++i)
      if (!exhibits_[i].is_right) all += best.hypothesis.tone ? base_[i].squares : simplest_[i];
    return all > 0 ? 1 - best.squares / all : 0;
  }
  Diagnosis Concluded(const Scored& best, const std::vector<Scored>& singles) const {
    constexpr double most_of_it = 0.8;
    std::vector<Hypothesis> alternatives;
    const bool is_single = best.hypothesis.Size() == 1;
    if (is_single && best.cost == 0)
      for (const Scored& other : singles)
        if (other.cost == 0 && other.squares <= best.squares + AsGood() &&
            other.hypothesis.Names() != best.hypothesis.Names())
          alternatives.push_back(other.hypothesis);
    const double share = ShareOf(best);
    using enum Diagnosis::Kind;
    const bool is_named = best.cost == 0 || IsEstablished(best.hypothesis);
    return Found(best, std::move(alternatives), is_named ? named : share > most_of_it ? resembles : unknown);
  }
  Diagnosis Found(const Scored& best, std::vector<Hypothesis> alternatives, Diagnosis::Kind kind) const {
    Diagnosis found{kind, best.hypothesis, std::move(alternatives), ShareOf(best), {}, {}, {}};
    for (std::size_t scene = 0; scene < exhibits_.size(); ++scene) {
      SceneImages& images = *exhibits_[scene].images;
      const auto fit = FitOf(exhibits_[scene], ImageWith(images, best.hypothesis));
      found.explains.push_back(fit && IsWhole(scene, *fit));
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
  std::vector<double> simplest_;  // squares that the best simple change leaves
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
  return Compare(MakeSubmission({*made}, false, images), images).Percent();
}

bool IsVisible(SceneImages& images, const MistakeList& mistakes) {
  return PercentChanged(images, mistakes) > images.scene().allowed;
}

}  // namespace ray::grade
