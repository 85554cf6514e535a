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
  /// "gamma+mirrored": for tables.
  std::string Names() const;
  /// "no shadows, and the image is mirrored left to right".
  std::string Titles() const;
};

/// What all scenes of a student together say.
struct Diagnosis {
  enum class Kind {
    right,      // no scene differs
    named,      // the causes explain all that differs, at least in every scene that they change
    resembles,  // the causes explain most of what differs, but not enough to be named
    unknown
  };

  Kind kind = Kind::unknown;
  Hypothesis causes;
  std::vector<Hypothesis> alternatives;  // single causes that fit as well: the suite cannot tell them apart
  double share = 0;                      // of the squared difference that the causes explain, 0 to 1
  std::vector<bool> explains;            // by scene: whether they explain all that differs there
  std::vector<Hypothesis> shown;         // by scene: those causes that change it
  std::vector<double> specks;            // by scene: percent of the pixels that have shadow acne
};

/// The share of the difference that causes must explain in a scene.
inline constexpr double least_share = 0.95;

/// Finds the causes of all that differs in a student's images.
///
/// Tried are simple changes of the image, every mistake, pairs, and threes that begin with the best pair. A hypothesis
/// must fit all scenes together: those that differ must have at most 5% of their squared difference left, and 15% of
/// the pixels that differ, and those that are right must not be changed by it. What remains is compared with what the
/// best simple change leaves.
Diagnosis Diagnose(std::span<const Exhibit> exhibits);

/// Returns the image of a scene with the causes, values for a screen; the reference where they cannot be made.
R2::Image ImageWith(SceneImages& images, const Hypothesis& hypothesis);

/// True if the mistakes change more of the steady pixels than the suite allows.
bool IsVisible(SceneImages& images, const MistakeList& mistakes);
/// Returns the percentage of steady pixels that the mistakes change, 0 where they cannot be made.
double PercentChanged(SceneImages& images, const MistakeList& mistakes);

}  // namespace ray::grade
