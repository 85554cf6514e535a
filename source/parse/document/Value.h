#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace ray {

struct Collection;

/// Where something is written: bytes of the document's text.
struct Extent {
  std::size_t offset = 0, length = 1;
};

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

}  // namespace ray
