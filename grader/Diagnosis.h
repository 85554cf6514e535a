#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "grader/Misfit.h"
#include "grader/Tone.h"

namespace ray::grade {

/// Mistakes that were made together, and a simple change of all finished images.
struct Hypothesis {
  MistakeList mistakes;
  std::optional<Tone> tone;

  std::size_t Size() const { return mistakes.size() + (tone ? 1 : 0); }
  /// Returns the names for tables: "gamma+mirrored".
  std::string Names() const;
  /// Returns the titles for people: "no shadows, and the image is mirrored left to right".
  std::string Titles() const;
};

/// The conclusions from all scenes of a student together.
struct Diagnosis {
  enum class Kind {
    right,      // no scene differs
    named,      // the causes explain the whole difference
    in_part,    // the causes explain every scene that they change, but other scenes differ too
    resembles,  // the causes explain most of the difference
    unknown
  };

  Kind kind = Kind::unknown;
  Hypothesis causes;
  // single causes that fit equally well, so that the suite cannot distinguish them
  std::vector<Hypothesis> alternatives;
  double share = 0;                      // explained share of the squared difference, 0 to 1
  std::vector<bool> explains;            // by scene: true if the causes explain the whole difference
  std::vector<Hypothesis> shown;         // by scene: the causes that change it
  std::vector<double> specks;            // by scene: percentage of the pixels with shadow acne
};

/// The share of the difference that causes must explain in a scene.
inline constexpr double least_share = 0.95;

/// Finds the causes of the differences in a student's images.
///
/// Tries simple changes of the image, every mistake, pairs, and threes that begin with the best pair. A hypothesis must
/// fit all scenes together: those that differ must have at most 5% of their squared difference left, on at most twice
/// the pixels that a right image may have wrong, and it must not change those that are right. The remainder is compared
/// with that of the best simple change.
Diagnosis Diagnose(std::span<const Exhibit> exhibits);

/// Returns the image of a scene with the causes, as displayed; the reference if they do not apply.
R2::Image ImageWith(SceneImages& images, const Hypothesis& hypothesis);

/// Returns true if the mistakes change more of the steady pixels than the suite allows.
bool IsVisible(SceneImages& images, const MistakeList& mistakes);
/// Returns the percentage of steady pixels that the mistakes change; 0 if they do not apply.
double PercentChanged(SceneImages& images, const MistakeList& mistakes);

}  // namespace ray::grade
