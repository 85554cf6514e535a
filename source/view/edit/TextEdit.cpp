#include "source/view/edit/TextEdit.h"

#include <stdexcept>

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

}  // namespace ray
