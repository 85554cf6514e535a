#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/parse/document/Document.h"

namespace ray {

/// A builder that makes the tree of a document from the events of a parser, within the limits of Document. Open
/// collections are on a stack, so that nothing recurses. In a mapping every other value is a key.
class DocumentBuilder {
 public:
  /// The entry that counts among duplicate keys, as in the courses' parsers: yaml-cpp finds the first, those of JSON
  /// keep the last.
  enum class Repeated { first_counts, last_counts };

  DocumentBuilder(const Text& text, const TextPlaces& places, Report& report, Repeated repeated)
      : text_(text), places_(places), report_(report), repeated_(repeated) {}

  void Begin(Value::Kind kind, const Extent& extent);
  /// Ends the open collection. This and Add return the value at its new position, valid until the next event; for a
  /// key, the result is meaningless.
  const Value& End();
  const Value& Add(Value value);
  /// Adds a copy of the value of an anchor.
  void AddAlias(Value value, const Extent& extent);

  bool ExpectsKey() const { return !open_.empty() && open_.back().expects_key; }
  bool IsInSequence() const { return !open_.empty() && open_.back().value.kind == Value::Kind::sequence; }
  /// Returns the position to report for an absent value: its key, or else the beginning of the collection.
  Extent LastKey() const;
  /// Returns the beginning of the innermost open collection, if there is one.
  std::optional<Extent> Innermost() const;
  /// Returns the root; to be called after every collection was closed.
  Value TakeRoot() { return std::move(root_); }

  [[noreturn]] void Fail(const Extent& extent, const std::string& message, const std::string& hint = {}) const;

 private:
  struct Open {
    Value value;
    Collection collection;
    bool expects_key = false;
  };

  const Value& Place(Value value);
  void Count(std::size_t values, const Extent& extent);
  void CheckDepth(std::size_t depth, const Extent& extent) const;
  void DropRepeated(Collection& mapping);
  void Merge(Collection& mapping);

  const Text& text_;
  const TextPlaces& places_;
  Report& report_;
  Repeated repeated_;
  std::vector<Open> open_;
  Value root_;
  std::size_t values_ = 0;
};

/// Throws SceneError for characters that are not text: NUL and other control characters, and files in UTF-16.
void CheckCharacters(const Text& text, const TextPlaces& places);
/// Returns the length in bytes of the byte order mark at the start of the text.
std::size_t ByteOrderMark(const Text& text);

}  // namespace ray
