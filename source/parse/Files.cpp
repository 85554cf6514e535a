#include "source/parse/Files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "source/parse/Text.h"
#include "source/text/LowerCase.h"
#include "source/text/Suggestion.h"

namespace ray {
namespace fs = std::filesystem;
namespace {

bool IsBelow(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// Returns the canonical path without the empty last part after a trailing slash.
std::optional<std::string> CanonicalFolder(const fs::path& folder) {
  std::error_code error;
  fs::path canonical = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
  if (error) return {};
  return canonical.string();
}

/// Returns the path with slashes; Windows uses backslashes.
std::string WithSlashes(std::string path) {
  std::ranges::replace(path, '\\', '/');
  return path;
}

bool IsUpward(std::string_view path) { return path.starts_with("../"); }

/// Returns true for the path of another folder or computer: "../x.png", "/home/me/x.png", "C:/x.png".
bool IsForeign(std::string_view path) {
  const bool has_drive = path.substr(0, 3).ends_with(":/") && LowerCase(path[0]) >= 'a' && LowerCase(path[0]) <= 'z';
  return IsUpward(path) || path.starts_with('/') || path.starts_with("~/") || has_drive;
}

/// Returns the paths, relative to the folder of the file that names it, where a file with a foreign path is searched.
std::vector<std::string> PlacesOf(const std::string& foreign) {
  std::string_view below = foreign;
  while (IsUpward(below)) below.remove_prefix(3);
  const std::string file = fs::path(foreign).filename().string();
  std::vector<std::string> places;
  if (IsUpward(foreign)) places.push_back(std::string(below));
  for (const char* folder : {"", "textures/", "../", "../textures/"}) places.push_back(folder + file);
  return places;
}

/// Returns the nearest name of a regular file in the folder, or an empty text. Files with the extension `unlike` count
/// only if the missing one has it as well, since a scene is not a texture.
std::string SimilarFile(const fs::path& folder, const fs::path& name, const std::string& unlike) {
  constexpr int most_listed = 10'000;
  std::vector<std::string> names;
  std::error_code error;
  fs::directory_iterator entry(folder.empty() ? "." : folder, error);
  for (int i = 0; !error && entry != fs::directory_iterator() && i < most_listed; entry.increment(error), ++i) {
    const std::string extension = LowerCase(entry->path().extension().string());
    std::error_code ignored;
    if (entry->is_regular_file(ignored) && (extension != unlike || LowerCase(name.extension().string()) == unlike))
      names.push_back(entry->path().filename().string());
  }
  std::ranges::sort(names);
  const std::vector<std::string_view> choices(names.begin(), names.end());
  const std::string_view nearest = Nearest(name.filename().string(), choices);
  return nearest.empty() ? "" : (name.parent_path() / nearest).string();
}

/// Returns a "did you mean" hint, or an empty text.
std::string Meaning(const std::string& file) { return file.empty() ? "" : "did you mean " + Quoted(file) + "?"; }

}  // namespace

Files::Files(const std::string& top_scene, const std::vector<std::string>& allowed_folders)
    : top_(top_scene == "-" ? standard_input_name : top_scene) {
  for (const fs::path& folder : {fs::path(top_).parent_path(), fs::path(".")})
    if (auto root = CanonicalFolder(folder)) roots_.push_back(std::move(*root));
  for (const std::string& folder : allowed_folders) {
    auto root = CanonicalFolder(folder);
    // Otherwise it would be accepted silently, and its files refused later.
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
  if (error && fs::exists(top_, ignored)) return {top_, top_};  // a pipe, which has no path: Read reports it
  if (error == std::errc::no_such_file_or_directory) {
    const bool lacks_extension = fs::exists(top_ + ".scn", error);
    const fs::path folder = fs::path(top_).parent_path();
    throw FileError{"no such file", Meaning(lacks_extension ? top_ + ".scn" : SimilarFile(folder, top_, {}))};
  }
  if (error) throw FileError{"cannot be opened: " + error.message(), {}};
  return {top_, canonical.string()};
}

FoundFile Files::Find(const std::string& name, const std::string& named_in) const {
  const std::array folders{fs::path(named_in).parent_path().string(), std::string()};
  return FindIn(folders, name);
}

FoundFile Files::FindIn(std::span<const std::string> folders, const std::string& name) const {
  std::optional<FileError> denied;
  for (const std::string& folder : folders)
    if (auto found = FindAt(folder, name, denied)) return *found;
  if (auto found = FindElsewhere(folders, name)) return *found;
  if (denied) throw *denied;
  const std::string similar = SimilarIn(folders, name);
  throw FileError{"no such file: " + Quoted(name), Meaning(similar), similar};
}

std::optional<FoundFile> Files::FindElsewhere(std::span<const std::string> folders, const std::string& name) const {
  const std::string path = WithSlashes(name);
  if (!IsForeign(path) || fs::path(path).filename().empty()) return {};
  std::optional<FileError> refusal;
  for (const std::string& folder : folders)
    for (const std::string& place : PlacesOf(path)) try {
        const auto found = FindAt(folder, place, refusal);
        if (!found) continue;
        remarks_.insert(Quoted(name) + " does not exist; reading " + Quoted(found->shown) + " instead");
        return found;
      } catch (const FileError& error) {
        refusal = error;
      }
  if (refusal) throw *refusal;
  return {};
}

std::optional<FoundFile> Files::FindAt(const std::string& folder, const std::string& name,
                                       std::optional<FileError>& denied) const {
  const fs::path candidate = fs::path(folder) / name;  // only the name if that is absolute
  std::error_code error;
  const fs::path canonical = fs::canonical(candidate, error);
  if (error == std::errc::no_such_file_or_directory) return {};
  const FileError problem{"cannot open " + Quoted(name) + ": " + error.message(), {}};
  if (error == std::errc::permission_denied) return denied = problem, std::nullopt;
  if (error) throw problem;
  if (!IsAllowed(canonical.string())) {
    const std::string parent = canonical.parent_path().string();
    const std::string outside = parent.find(' ') == parent.npos ? Escaped(parent) : Quoted(parent);
    throw FileError{Quoted(name) + " is outside the scene's folder and the current folder",
                    "-allow_path " + outside + " allows it"};
  }
  return FoundFile{candidate.lexically_normal().string(), canonical.string()};
}

/// Returns a similar name; searches only folders that the file might have been read from.
std::string Files::SimilarIn(std::span<const std::string> folders, const std::string& name) const {
  const std::string extension = LowerCase(fs::path(top_).extension().string());
  const fs::path wanted(WithSlashes(name));
  for (const std::string& folder : folders) {
    const auto place = CanonicalFolder(folder / wanted.parent_path());
    if (!place || !IsAllowed(*place)) continue;
    if (std::string similar = SimilarFile(*place, wanted, extension); !similar.empty()) return similar;
  }
  return {};
}

std::string Files::Read(const FoundFile& file) const {
  return file.canonical == standard_input_name ? StandardInput() : ReadFile(file);
}

bool Files::IsAllowed(const std::string& canonical) const {
  return std::any_of(roots_.begin(), roots_.end(), [&](const std::string& root) { return IsBelow(canonical, root); });
}

}  // namespace ray
