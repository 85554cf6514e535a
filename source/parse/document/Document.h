#pragma once

#include <memory>
#include <string>
#include <vector>

#include "source/parse/SceneError.h"
#include "source/parse/Text.h"

namespace ray {

struct Collection;

/// A value of a YAML or JSON document, with its place. Copies share what they hold.
struct Value {
  enum class Kind { null, scalar, sequence, mapping };

  Kind kind = Kind::null;
  bool is_quoted = false;     // a scalar that can only be text
  bool may_be_number = true;  // not in JSON's quotation marks; in those of YAML students write numbers
  bool is_alias = false;      // stands here by a YAML alias; its place is that of the anchor
  Extent extent;              // of a collection, the beginning only
  std::string scalar;         // numbers as they are written
  std::shared_ptr<const Collection> collection;

  /// The entries of a collection, none of anything else.
  const std::vector<struct Entry>& Entries() const;
};

/// A key of a mapping and its value; in a sequence the key is empty.
struct Entry {
  std::string key;
  Extent key_extent;
  Value value;
};

struct Collection {
  std::vector<Entry> entries;
  std::size_t values = 1;  // in it and below it, and itself, each alias counted with all that it stands for
  int height = 1;          // levels of collections, itself included
};

/// "a mapping", "a list", "a single value", "nothing": for messages.
const char* NameOf(Value::Kind kind);

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
