#pragma once

#include <optional>
#include <string>
#include <vector>

#include "source/parse/document/Document.h"

namespace ray {

/// Makes the tree of a document from the events of a parser, and keeps it within the limits of Document. Open
/// collections are on a stack, so that nothing recurses. In a mapping every other value is a key.
class DocumentBuilder {
 public:
  /// Which of several entries of one key counts, as in the courses' parsers: yaml-cpp finds the first, those of JSON
  /// keep the last.
  enum class Repeated { first_counts, last_counts };

  DocumentBuilder(const Text& text, const TextPlaces& places, Report& report, Repeated repeated)
      : text_(text), places_(places), report_(report), repeated_(repeated) {}

  void Begin(Value::Kind kind, const Extent& extent);
  /// These give the value where it now is, valid until the next event; of a key, nothing useful.
  const Value& End();
  const Value& Add(Value value);
  /// A copy of what an anchor names.
  void AddAlias(Value value, const Extent& extent);

  bool ExpectsKey() const { return !open_.empty() && open_.back().expects_key; }
  bool IsInSequence() const { return !open_.empty() && open_.back().value.kind == Value::Kind::sequence; }
  /// Where an absent value is said to be: at its key, or else at the beginning of the collection.
  Extent LastKey() const;
  /// The beginning of the collection that is open, if any is.
  std::optional<Extent> Innermost() const;
  /// To be called once every collection is closed.
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

/// Throws SceneError for what no text holds: NUL and other control characters, and files of UTF-16.
void CheckCharacters(const Text& text, const TextPlaces& places);
/// How many bytes of a byte order mark the text begins with.
std::size_t ByteOrderMark(const Text& text);

}  // namespace ray
