#pragma once

#include <string>

#include "source/parse/Report.h"
#include "source/parse/Text.h"
#include "source/parse/document/TextPlaces.h"
#include "source/parse/document/Value.h"

namespace ray {

/// A YAML or JSON file as a tree of values.
class Document {
 public:
  /// How deep collections may nest, and how many values there may be in all, aliases counted with all that they stand
  /// for: about 2 GB of them.
  static constexpr int max_depth = 100;
  static constexpr std::size_t max_values = std::size_t{1} << 24;

  /// `places` must be of `text`.
  Document(const Text& text, const TextPlaces& places, Value root)
      : text_(text), places_(places), root_(std::move(root)) {}

  const Text& Source() const { return text_; }
  const Value& Root() const { return root_; }
  Token At(const Extent& extent) const { return places_.At(extent); }

  /// "Objects[2].material.kd"; empty for the root. Searched for, since only mistakes need it.
  std::string PathOf(const Value& value) const;

 private:
  const Text& text_;
  const TextPlaces& places_;
  Value root_;
};

/// These read a text that must outlive the result, as must `places`, which are its own. A byte order mark and any ends
/// of lines are taken. Keys given twice go to the report; all else that is wrong is thrown as SceneError: bad syntax,
/// control characters, nesting or values beyond the limits above (before they take memory or stack); of YAML also tags,
/// files of more than 32 MiB, keys that are no words, and aliases within their own anchor. A second YAML document is
/// ignored with a warning.
Document ReadYaml(const Text& text, const TextPlaces& places, Report& report);
Document ReadJson(const Text& text, const TextPlaces& places, Report& report);

}  // namespace ray
