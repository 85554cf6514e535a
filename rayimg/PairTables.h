#pragma once

#include <span>
#include <string>
#include <vector>

#include "rayimg/PairResult.h"
#include "source/app/files/OutputFile.h"

namespace ray::rayimg {

/// The files of -html and -csv.
class PairTables {
 public:
  /// Checks the files. Throws OutputError if one cannot be written, and UsageError if both are the same.
  PairTables(const ImageOptions& options, std::span<const std::string> inputs);

  bool AreWanted() const { return page_ || table_; }
  /// Throws OutputError.
  void Write(const std::vector<PairResult>& results) const;

 private:
  std::string title_;
  std::optional<OutputFile> page_, table_;
};

/// Returns text for people: a line for each pair, and one with their counts.
std::string TextOf(const std::vector<PairResult>& results);
std::string JsonOf(const std::vector<PairResult>& results, const ImageOptions& options);
std::string CsvOf(const std::vector<PairResult>& results);
/// Returns a self-contained page without scripts.
std::string PageOf(const std::vector<PairResult>& results, const std::string& title);

}  // namespace ray::rayimg
