#pragma once

#include <initializer_list>
#include <utility>
#include <vector>

namespace ray {

struct Options;

/// What an option changes, and where it may stand.
enum class Fact : unsigned {
  // It changes:
  image = 1,      // what the image shows
  samples = 2,    // how many samples the image takes
  budget = 4,     // when the render stops to take samples
  speed = 8,      // how fast the render is, never the image
  run = 16,       // this run alone: neither the image nor the command that makes it again
  reading = 32,   // how the scene is read
  messages = 64,  // what is printed, or reported in a file
  window = 128,   // the window at its start
  // It may stand:
  in_scenes = 256,          // in a scene file, as a setting
  before_budgets = 512,     // in a scene file, unless -time or -error is given
  with_convert = 1024,      // beside -convert, which renders nothing
  one_image = 2048,         // not where several scenes are rendered
  named_image = 4096,       // not where the image goes to standard output
  whole_image = 8192,       // not where a part of the image is rendered
  changes_on_resume = 16384,  // with another value where a render is resumed
};

/// A condition without which an option has no effect.
struct OptionNeed {
  bool (*is_met)(const Options&);
  const char* otherwise;  // "without -aperture": ends the sentence that begins with "-focus has no effect"
};

struct Needs : std::vector<OptionNeed> {
  using vector::vector;
};
/// Names of options that contradict this one.
struct Excludes : std::vector<const char*> {
  using vector::vector;
};
/// The names that other renderers give to this option. They are errors that name ours.
struct ElsewhereCalled : std::vector<const char*> {
  using vector::vector;
};

/// What the rest of the program must know of an option: `image | in_scenes | Needs{a_lens}` in its row of the table.
struct OptionFacts {
  OptionFacts() = default;
  OptionFacts(Fact fact) : bits(static_cast<unsigned>(fact)) {}
  OptionFacts(Needs given) : needs(std::move(given)) {}
  OptionFacts(Excludes given) : excludes(std::move(given)) {}
  OptionFacts(ElsewhereCalled given) : elsewhere(std::move(given)) {}

  /// Whether one of the facts is true.
  bool HasAny(std::initializer_list<Fact> some) const {
    for (const Fact fact : some)
      if ((bits & static_cast<unsigned>(fact)) != 0) return true;
    return false;
  }
  bool Has(Fact fact) const { return HasAny({fact}); }

  unsigned bits = 0;
  Needs needs;
  Excludes excludes;
  ElsewhereCalled elsewhere;
};

inline OptionFacts operator|(OptionFacts a, const OptionFacts& b) {
  a.bits |= b.bits;
  a.needs.insert(a.needs.end(), b.needs.begin(), b.needs.end());
  a.excludes.insert(a.excludes.end(), b.excludes.begin(), b.excludes.end());
  a.elsewhere.insert(a.elsewhere.end(), b.elsewhere.begin(), b.elsewhere.end());
  return a;
}
inline OptionFacts operator|(Fact a, Fact b) { return OptionFacts(a) | OptionFacts(b); }

}  // namespace ray
