#pragma once

#include <initializer_list>
#include <utility>
#include <vector>

namespace ray {

struct Options;

/// The effects of an option, and where it is allowed.
enum class Fact : unsigned {
  // Effects:
  image = 1,      // the content of the image
  samples = 2,    // the number of samples of the image
  budget = 4,     // when the render stops taking samples
  speed = 8,      // the speed of the render, never the image
  run = 16,       // only this run: neither the image nor the command that reproduces it
  reading = 32,   // how the scene is read
  messages = 64,  // the messages, or the report
  window = 128,   // the initial window
  // Allowed:
  in_scenes = 256,            // in a scene file, as a setting
  before_budgets = 512,       // in a scene file, unless -time or -error is given
  with_convert = 1024,        // with -convert, which renders nothing
  one_image = 2048,           // only with a single scene
  named_image = 4096,         // only if the image has a file name
  whole_image = 8192,         // only if the whole image is rendered
  changes_on_resume = 16384,  // with another value when a render is resumed
};

/// A condition without which an option has no effect.
struct OptionNeed {
  bool (*is_met)(const Options&);
  const char* otherwise;  // "without -aperture": ends a message that begins with "-focus has no effect"
};

struct Needs : std::vector<OptionNeed> {
  using vector::vector;
};
/// The names of options that contradict this one.
struct Excludes : std::vector<const char*> {
  using vector::vector;
};
/// The names of this option in other renderers. Using one is an error whose message names ours.
struct ElsewhereCalled : std::vector<const char*> {
  using vector::vector;
};

/// The properties of an option for the rest of the program: `image | in_scenes | Needs{a_lens}` in its row of the
/// table.
struct OptionFacts {
  OptionFacts() = default;
  OptionFacts(Fact fact) : bits(static_cast<unsigned>(fact)) {}
  OptionFacts(Needs given) : needs(std::move(given)) {}
  OptionFacts(Excludes given) : excludes(std::move(given)) {}
  OptionFacts(ElsewhereCalled given) : elsewhere(std::move(given)) {}

  /// Returns true if one of the facts holds.
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
