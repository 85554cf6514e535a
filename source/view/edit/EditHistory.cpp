#include "source/view/edit/EditHistory.h"

#include <cassert>
#include <utility>

namespace ray {

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
