#pragma once

#include <cstddef>
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

/// Where what stood at `offset` of a file stands after the edits. An insertion right there is not in front of it: the
/// offset is then that of what was inserted.
std::size_t OffsetAfter(std::span<const TextEdit> edits, const std::string& file, std::size_t offset);

}  // namespace ray
