#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "source/parse/Parse.h"

namespace ray {

/// One replacement in a file: at the offset `at` stands `before`, and `after` takes its place. The file is named by its
/// canonical path, as in EditedFiles.
struct TextEdit {
  std::string file;
  std::size_t at = 0;
  std::string before, after;
};

/// Edits that are done, undone and redone together, each made for the text that the ones before it leave.
using TextEdits = std::vector<TextEdit>;

/// The files with the edits done. Every edited file must be among `files`. Throws std::logic_error where a text does
/// not have what an edit replaces.
EditedFiles Edited(EditedFiles files, std::span<const TextEdit> edits);

/// The edits that take these back.
TextEdits Reversed(std::span<const TextEdit> edits);

/// Returns the offset after the edits of what was at `offset` of a file. An insertion right there is not in front of
/// it: the offset is then that of what was inserted.
std::size_t OffsetAfter(std::span<const TextEdit> edits, const std::string& file, std::size_t offset);

/// The place of something that can be chosen: the offset of its statement in a file, named by its canonical path.
struct EditPlace {
  std::string file;
  std::size_t begin = 0;
  friend bool operator==(const EditPlace&, const EditPlace&) = default;
};

/// One step of undo: what it is called, its edits, and what was chosen before and after them.
struct Change {
  std::string what;  // "move sphere, line 16"
  std::string key;   // changes of one gesture, as of a slider that is dragged, have the same key and become one
  TextEdits edits;
  std::optional<EditPlace> chosen_before{}, chosen_after{};
};

/// The changes that can be undone and redone.
class EditHistory {
 public:
  /// Changes that were undone are forgotten. One that continues the last one becomes a part of it.
  void Do(Change change, bool continues);
  /// The change to take back or to do again; null where there is none.
  const Change* ToUndo() const { return done_ > 0 ? &changes_[done_ - 1] : nullptr; }
  const Change* ToRedo() const { return done_ < changes_.size() ? &changes_[done_] : nullptr; }
  /// Moves on to the change before, or behind, which must be there.
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
