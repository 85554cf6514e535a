#include "rayimg/FolderDiff.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "rayimg/ImageFolder.h"
#include "rayimg/PairTables.h"
#include "source/app/Status.h"

namespace ray::rayimg {
namespace {

using std::filesystem::path;
using Files = std::vector<std::string>;

std::string WholeName(const std::string& file) { return path(file).filename().string(); }
std::string Stem(const std::string& file) { return path(file).stem().string(); }

/// Removes and returns the files that have exactly one partner by that name.
std::vector<Pair> TakePairs(Files& images, Files& references, std::string (*name_of)(const std::string&)) {
  std::map<std::string, std::pair<Files, Files>> by_name;
  for (const std::string& file : images) by_name[name_of(file)].first.push_back(file);
  for (const std::string& file : references) by_name[name_of(file)].second.push_back(file);
  std::vector<Pair> pairs;
  images.clear(), references.clear();
  for (const auto& [name, files] : by_name) {
    const auto& [ours, theirs] = files;
    if (ours.size() == 1 && theirs.size() == 1) {
      pairs.push_back({WholeName(ours[0]), ours[0], theirs[0]});
    } else {
      images.insert(images.end(), ours.begin(), ours.end());
      references.insert(references.end(), theirs.begin(), theirs.end());
    }
  }
  return pairs;
}

PairResult WithoutPartner(const Pair& pair) {
  return {.pair = pair,
          .outcome = Outcome::unpaired,
          .remark = pair.image.empty() ? "there is no image of that name" : "there is no reference of that name",
          .found = {},
          .cause = {},
          .figures = {}};
}

/// Sorts failed measurements first; NaN counts as the largest difference.
void SortByDifference(std::vector<PairResult>& results) {
  const auto key = [](const PairResult& result) {
    const auto amount = [](double number) { return std::isnan(number) ? HUGE_VAL : number; };
    if (!result.found) return std::pair{-1.0 - HUGE_VAL, -static_cast<double>(result.outcome)};
    return std::pair{-amount(result.found->flip), -amount(result.found->difference.rmse)};
  };
  std::ranges::stable_sort(results, {}, key);
}

int ExitStatus(const std::vector<PairResult>& results) {
  const auto worst = std::ranges::max(results, {}, &PairResult::outcome).outcome;
  if (worst == Outcome::unreadable) return status::bad_scene;
  return worst >= Outcome::fails ? status::failed : status::done;
}

void RefuseOptionsOfImages(const ImageOptions& options) {
  const auto refuse = [](const std::string& value, const std::string& option) {
    if (!value.empty()) throw UsageError(option + " needs two images; with folders, -html shows maps");
  };
  refuse(options.map, "-map");
  refuse(options.reference2, "-reference2");
}

}  // namespace

std::vector<Pair> PairsOf(const Files& images, const Files& references) {
  Files ours = images, theirs = references;
  std::vector<Pair> pairs = TakePairs(ours, theirs, WholeName);
  for (const Pair& pair : TakePairs(ours, theirs, Stem)) pairs.push_back(pair);
  std::ranges::sort(pairs, {}, &Pair::name);
  for (const std::string& file : ours) pairs.push_back({WholeName(file), file, ""});
  for (const std::string& file : theirs) pairs.push_back({WholeName(file), "", file});
  return pairs;
}

int DiffFolders(const ImageOptions& options) {
  RefuseOptionsOfImages(options);
  const Files images = ImagesIn(options.names[0]), references = ImagesIn(options.names[1]);
  Files inputs = images;
  inputs.insert(inputs.end(), references.begin(), references.end());
  const PairTables tables(options, inputs);

  std::vector<PairResult> results;
  for (const Pair& pair : PairsOf(images, references))
    results.push_back(pair.image.empty() || pair.reference.empty() ? WithoutPartner(pair) : Compared(pair, options));
  SortByDifference(results);
  tables.Write(results);
  WriteStandardOutput(options.json ? JsonOf(results, options) : TextOf(results));
  return ExitStatus(results);
}

}  // namespace ray::rayimg
