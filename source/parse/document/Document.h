#pragma once

#include <memory>
#include <string>
#include <vector>

#include "source/parse/SceneError.h"
#include "source/parse/Text.h"

namespace ray {

struct Collection;

/// A value of a YAML or JSON document, with its position. Copies share their contents.
struct Value {
  enum class Kind { null, scalar, sequence, mapping };

  Kind kind = Kind::null;
  bool is_quoted = false;     // a scalar that can only be text
  bool may_be_number = true;  // false for text in JSON's quotation marks; in YAML students quote numbers
  bool is_alias = false;      // inserted by a YAML alias; its position is that of the anchor
  Extent extent;              // of a collection, only the beginning
  std::string scalar;         // numbers as they are written
  std::shared_ptr<const Collection> collection;

  /// Returns the entries of a collection; empty for other values.
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
  std::size_t values = 1;  // number of values in it and below it, including itself and the full contents of aliases
  int height = 1;          // levels of collections, including itself
};

/// Returns "a mapping", "a list", "a single value" or "nothing", for messages.
const char* NameOf(Value::Kind kind);

/// A YAML or JSON file as a tree of values.
class Document {
 public:
  /// The maximum nesting depth of collections, and the maximum number of values, including the full contents of
  /// aliases: about 2 GB.
  static constexpr int max_depth = 100;
  static constexpr std::size_t max_values = std::size_t{1} << 24;

  /// Makes a document; `places` must be of `text`.
  Document(const Text& text, const TextPlaces& places, Value root)
      : text_(text), places_(places), root_(std::move(root)) {}

  const Text& Source() const { return text_; }
  const Value& Root() const { return root_; }
  Token At(const Extent& extent) const { return places_.At(extent); }

  /// Returns "Objects[2].material.kd"; empty for the root. Computed by a search, since only mistakes need it.
  std::string PathOf(const Value& value) const;

 private:
  const Text& text_;
  const TextPlaces& places_;
  Value root_;
};

/// Reads a YAML document. ReadJson reads JSON. `text` and `places`, which must be its own, must outlive the result. A
/// byte order mark and any line ends are accepted. Duplicate keys go to the report; all other mistakes are thrown as
/// SceneError: bad syntax, control characters, nesting or values beyond the limits above (before they take memory or
/// stack); for YAML also tags, files of more than 32 MiB, keys that are not words, and aliases within their own anchor.
/// A second YAML document is ignored with a warning.
Document ReadYaml(const Text& text, const TextPlaces& places, Report& report);
Document ReadJson(const Text& text, const TextPlaces& places, Report& report);

}  // namespace ray
