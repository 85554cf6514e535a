#include "source/parse/Files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "source/parse/ReadFile.h"
#include "source/parse/Text.h"
#include "source/text/LowerCase.h"
#include "source/text/SimilarFile.h"

namespace ray {
namespace fs = std::filesystem;
namespace {

bool IsBelow(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// Without the empty last part that a trailing slash leaves.
std::optional<std::string> CanonicalFolder(const fs::path& folder) {
  std::error_code error;
  fs::path canonical = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
  if (error) return {};
  return canonical.string();
}

constexpr std::string_view one_up = "../";

/// A hint, or none.
std::string Meaning(const std::string& file) { return file.empty() ? "" : "did you mean " + Quoted(file) + "?"; }

}  // namespace

Files::Files(const std::string& top_scene, const std::vector<std::string>& allowed_folders)
    : top_(top_scene == "-" ? standard_input_name : top_scene) {
  for (const fs::path& folder : {fs::path(top_).parent_path(), fs::path(".")})
    if (auto root = CanonicalFolder(folder)) roots_.push_back(std::move(*root));
  for (const std::string& folder : allowed_folders) {
    auto root = CanonicalFolder(folder);
    // Else it would be allowed without a word, and its files be refused.
    if (!root) throw FileError{"-allow_path " + QuotedPath(folder) + ": there is no such folder", {}};
    if (!fs::is_directory(*root)) throw FileError{"-allow_path " + QuotedPath(folder) + ": it is not a folder", {}};
    roots_.push_back(std::move(*root));
  }
}

FoundFile Files::Top() const {
  if (IsStandardInput()) return {top_, top_};
  std::error_code error;
  const fs::path canonical = fs::canonical(top_, error);
  std::error_code ignored;
  if (error && fs::exists(top_, ignored)) return {top_, top_};  // a pipe, which has no path: Read says so
  if (error == std::errc::no_such_file_or_directory) {
    const bool lacks_extension = fs::exists(top_ + ".scn", error);
    const auto may_list = [](const fs::path&) { return true; };  // the user named it
    throw FileError{"no such file", Meaning(lacks_extension ? top_ + ".scn" : SimilarFile({}, top_, {}, may_list))};
  }
  if (error) throw FileError{"cannot be opened: " + error.message(), {}};
  return {top_, canonical.string()};
}

FoundFile Files::Find(const std::string& name, const std::string& named_in) const {
  const std::array folders{fs::path(named_in).parent_path().string(), std::string()};
  return FindIn(folders, name);
}

FoundFile Files::FindIn(std::span<const std::string> folders, const std::string& name) const {
  for (const std::string& folder : folders)
    if (auto found = FindAt(folder, name)) return *found;
  if (name.starts_with(one_up)) {
    const std::string below = name.substr(one_up.size());
    for (const std::string& folder : folders)
      if (auto found = FindAt(folder, below)) {
        remarks_.insert(Quoted(name) + " is not there; " + Quoted(found->shown) + " is read");
        return *found;
      }
  }
  throw FileError{"no such file: " + Quoted(name), Meaning(SimilarIn(folders, name))};
}

std::optional<FoundFile> Files::FindAt(const std::string& folder, const std::string& name) const {
  const fs::path candidate = fs::path(folder) / name;  // the name alone where that is absolute
  std::error_code error;
  const fs::path canonical = fs::canonical(candidate, error);
  if (error == std::errc::no_such_file_or_directory) return {};
  if (error) throw FileError{"cannot open " + Quoted(name) + ": " + error.message(), {}};
  if (!IsAllowed(canonical.string())) {
    const std::string outside = Escaped(canonical.parent_path().string());
    throw FileError{Quoted(name) + " is outside the scene's folder and the current folder",
                    "-allow_path " + outside + " allows it"};
  }
  return FoundFile{candidate.lexically_normal().string(), canonical.string()};
}

/// Looks only where the file might have been read from.
std::string Files::SimilarIn(std::span<const std::string> folders, const std::string& name) const {
  const std::string extension = LowerCase(fs::path(top_).extension().string());
  const auto may_list = [&](const fs::path& folder) {
    const auto canonical = CanonicalFolder(folder);
    return canonical && IsAllowed(*canonical);
  };
  for (const std::string& folder : folders)
    if (std::string similar = SimilarFile(folder, name, extension, may_list); !similar.empty()) return similar;
  return {};
}

std::string Files::Read(const FoundFile& file) const {
  return file.canonical == standard_input_name ? StandardInput() : ReadFile(file);
}

bool Files::IsAllowed(const std::string& canonical) const {
  return std::any_of(roots_.begin(), roots_.end(), [&](const std::string& root) { return IsBelow(canonical, root); });
}

}  // namespace ray
