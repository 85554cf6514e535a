#include "source/view/edit/EditHistory.h"

#include <cassert>
#include <stdexcept>
#include <utility>

namespace ray {

EditedFiles Edited(EditedFiles files, std::span<const TextEdit> edits) {
  for (const TextEdit& edit : edits) {
    std::string& text = files.at(edit.file);
    if (edit.at > text.size() || text.compare(edit.at, edit.before.size(), edit.before) != 0)
      throw std::logic_error("an edit does not fit the text of " + edit.file);
    text.replace(edit.at, edit.before.size(), edit.after);
  }
  return files;
}

TextEdits Reversed(std::span<const TextEdit> edits) {
  TextEdits reversed;
  for (std::size_t i = edits.size(); i-- > 0;)
    reversed.push_back({edits[i].file, edits[i].at, edits[i].after, edits[i].before});
  return reversed;
}

std::size_t OffsetAfter(std::span<const TextEdit> edits, const std::string& file, std::size_t offset) {
  for (const TextEdit& edit : edits)
    if (edit.file == file && edit.at + edit.before.size() <= offset && edit.at < offset)
      offset = offset - edit.before.size() + edit.after.size();
  return offset;
}

void EditHistory::Do(Change change, bool continues) {
  changes_.resize(done_);
  if (continues && Continues(change.key)) {
    Change& last = changes_.back();
    last.edits.insert(last.edits.end(), change.edits.begin(), change.edits.end());
    last.what = std::move(change.what);
    last.chosen_after = std::move(change.chosen_after);
    return;
  }
  if (changes_.size() >= most_changes) changes_.erase(changes_.begin());
  changes_.push_back(std::move(change));
  done_ = changes_.size();
  can_continue_ = true;
}

void EditHistory::Undo() {
  assert(done_ > 0);
  --done_;
  can_continue_ = false;
}

void EditHistory::Redo() {
  assert(done_ < changes_.size());
  ++done_;
  can_continue_ = false;
}

void EditHistory::Forget() {
  changes_.clear();
  done_ = 0;
  can_continue_ = false;
}

}  // namespace ray
