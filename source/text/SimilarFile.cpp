#include "source/text/SimilarFile.h"

#include <algorithm>
#include <vector>

#include "source/text/LowerCase.h"
#include "source/text/Suggestion.h"

namespace ray {
namespace fs = std::filesystem;
namespace {

constexpr int most_listed = 10'000;  // entries of a folder; a hint is not worth more

/// Names of the files in a folder, or of the folders, in order.
std::vector<std::string> NamesIn(const fs::path& folder, bool of_folders) {
  std::vector<std::string> names;
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (int i = 0; !error && entry != fs::directory_iterator() && i < most_listed; entry.increment(error), ++i) {
    std::error_code ignored;
    const bool fits = of_folders ? entry->is_directory(ignored) : entry->is_regular_file(ignored);
    if (fits) names.push_back(entry->path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

std::string NearestOf(const std::vector<std::string>& names, const std::string& name) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  return std::string(Nearest(name, views));
}

std::string SameInOtherCase(const std::vector<std::string>& names, const std::string& name) {
  const auto same = [&](const std::string& other) { return LowerCase(other) == LowerCase(name); };
  const auto found = std::ranges::find_if(names, same);
  return found == names.end() ? "" : *found;
}

std::string SimilarFolder(const fs::path& folder, const std::string& name) {
  const auto names = NamesIn(folder, true);
  if (std::string same = SameInOtherCase(names, name); !same.empty()) return same;
  return NearestOf(names, name);
}

std::string SimilarName(const fs::path& folder, const std::string& name, const std::string& unlike) {
  const auto names = NamesIn(folder, false);
  if (std::string same = SameInOtherCase(names, name); !same.empty()) return same;
  const fs::path wanted(name);
  const std::string stem = LowerCase(wanted.stem().string()), extension = LowerCase(wanted.extension().string());
  std::vector<std::string> same_stem, stems;  // with other extensions; of files with the same extension
  for (const fs::path file : names) {
    const std::string other = LowerCase(file.extension().string());
    if (other != extension && other != unlike && LowerCase(file.stem().string()) == stem)
      same_stem.push_back(file.string());
    if (other == extension) stems.push_back(LowerCase(file.stem().string()));
  }
  if (std::string nearest = NearestOf(same_stem, name); !nearest.empty()) return nearest;
  if (!same_stem.empty()) return same_stem.front();
  const std::string nearest = NearestOf(stems, stem);
  return nearest.empty() ? "" : SameInOtherCase(names, nearest + extension);
}

}  // namespace

std::string SimilarFile(const fs::path& folder, const std::string& name, const std::string& unlike,
                        const std::function<bool(const fs::path&)>& may_list) {
  std::string slashes = name;
  std::ranges::replace(slashes, '\\', '/');
  const fs::path wanted(slashes), start = folder.empty() ? "." : folder;
  fs::path found;
  for (const fs::path& part : wanted.parent_path()) {
    const fs::path here = start / found;
    std::error_code error;
    const bool is_there = fs::is_directory(here / part, error);
    const std::string known = is_there ? part.string() : may_list(here) ? SimilarFolder(here, part.string()) : "";
    // The path may be one of another machine, and the file lie here.
    if (known.empty()) return SimilarFile(folder, wanted.filename().string(), unlike, may_list);
    found /= known;
  }
  const fs::path here = start / found;
  const std::string last = wanted.filename().string();
  std::error_code error;
  if (fs::is_regular_file(here / last, error)) return (found / last).string();
  if (last.empty() || !may_list(here)) return "";
  const std::string similar = SimilarName(here, last, unlike);
  return similar.empty() ? "" : (found / similar).string();
}

}  // namespace ray
