#pragma once

#include <span>
#include <string>
#include <vector>

#include "source/app/files/OutputFile.h"
#include "source/rayimg/PairResult.h"

namespace ray::rayimg {

/// The files of -html and -csv.
class PairTables {
 public:
  /// Throws OutputError when one cannot be written, and UsageError when both are one.
  PairTables(const ImageOptions& options, std::span<const std::string> inputs);

  bool AreWanted() const { return page_ || table_; }
  /// Throws OutputError.
  void Write(const std::vector<PairResult>& results) const;

 private:
  std::string title_;
  std::optional<OutputFile> page_, table_;
};

/// For people: a line for each pair, and one that counts them.
std::string TextOf(const std::vector<PairResult>& results);
std::string JsonOf(const std::vector<PairResult>& results, const ImageOptions& options);
std::string CsvOf(const std::vector<PairResult>& results);
/// The page: one file, to be read without scripts.
std::string PageOf(const std::vector<PairResult>& results, const std::string& title);

}  // namespace ray::rayimg
