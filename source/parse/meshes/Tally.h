#pragma once

#include <cstddef>
#include <string>

#include "source/parse/Report.h"
#include "source/parse/Text.h"

namespace ray {

/// Counts what is odd about a file and remembers where it was seen first, for one warning about all of it.
class Tally {
 public:
  /// `where` is of no line in a binary file.
  void Add(const Token& where) {
    if (count_++ == 0) first_ = where;
  }
  bool IsEmpty() const { return count_ == 0; }
  const Token& First() const { return first_; }

  /// "a.off:5:1: warning: 3 faces skipped, the first of them here" for one = "face skipped", many = "faces skipped".
  /// Nothing when nothing was counted.
  void Warn(const Text& file, Report& report, const std::string& one, const std::string& many) const;

 private:
  std::size_t count_ = 0;
  Token first_;
};

/// Warns of normals and texture coordinates that are no finite numbers, or too large, and so were left out.
void WarnOfAbsent(const Tally& normals, const Tally& uvs, const Text& file, Report& report);

}  // namespace ray
