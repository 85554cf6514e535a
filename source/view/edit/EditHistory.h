#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "source/parse/Parse.h"

namespace ray {

/// One replacement in a file: of the text `before` at the offset `at` by `after`. The file is named by its
/// canonical path, as in EditedFiles.
struct TextEdit {
  std::string file;
  std::size_t at = 0;
  std::string before, after;
};

/// Edits that are made, undone and redone together; each applies to the result of those before it.
using TextEdits = std::vector<TextEdit>;

/// Returns the files after the edits. Every edited file must be in `files`. Throws std::logic_error if a file does not
/// contain the text that an edit replaces.
EditedFiles Edited(EditedFiles files, std::span<const TextEdit> edits);

/// Returns the edits that undo these.
TextEdits Reversed(std::span<const TextEdit> edits);

/// Returns the offset after the edits of the text at `offset` of a file. Text inserted at that very offset counts as
/// part of it: the offset is then that of the insertion.
std::size_t OffsetAfter(std::span<const TextEdit> edits, const std::string& file, std::size_t offset);

/// The place of an object that can be chosen: the offset of its statement in a file, named by its canonical path.
struct EditPlace {
  std::string file;
  std::size_t begin = 0;
  friend bool operator==(const EditPlace&, const EditPlace&) = default;
};

/// One step of undo: its name, its edits, and the selection before and after them.
struct Change {
  std::string what;  // "move sphere, line 16"
  std::string key;   // changes of one gesture, such as a drag of a slider, have the same key and become one
  TextEdits edits;
  std::optional<EditPlace> chosen_before{}, chosen_after{};
};

/// The changes that can be undone and redone.
class EditHistory {
 public:
  /// Adds a change and forgets those that were undone. A change that continues the last one becomes a part of it.
  void Do(Change change, bool continues);
  /// The change to undo or redo; null if there is none.
  const Change* ToUndo() const { return done_ > 0 ? &changes_[done_ - 1] : nullptr; }
  const Change* ToRedo() const { return done_ < changes_.size() ? &changes_[done_] : nullptr; }
  /// Moves to the previous or next change, which must exist.
  void Undo();
  void Redo();
  void Forget();
  /// True if the next change can become a part of the last one.
  bool Continues(const std::string& key) const { return can_continue_ && done_ > 0 && changes_[done_ - 1].key == key; }
  std::size_t Done() const { return done_; }
  std::size_t Undone() const { return changes_.size() - done_; }

 private:
  static constexpr std::size_t most_changes = 10'000;

  std::vector<Change> changes_;
  std::size_t done_ = 0;  // of changes_, from the first
  bool can_continue_ = false;
};

}  // namespace ray
