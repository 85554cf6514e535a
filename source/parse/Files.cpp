#include "source/parse/Files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "source/parse/Text.h"
#include "source/text/LowerCase.h"
#include "source/text/SimilarFile.h"

namespace ray {
namespace fs = std::filesystem;
namespace {

/// An open file, closed at the end of its scope.
class Handle {
 public:
  explicit Handle(int number) : number_(number) {}
  Handle(Handle&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Handle() {
    if (number_ >= 0) close(number_);
  }
  int Number() const { return number_; }
  bool IsOpen() const { return number_ >= 0; }

 private:
  int number_;
};

std::string Reason(int error) { return std::generic_category().message(error); }

// To walk through a folder needs no right to list it, where the system can tell the two apart.
#ifdef O_PATH
constexpr int folder_flags = O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
#else
constexpr int folder_flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
#endif

/// Opens a canonical path one folder at a time, following no link. A canonical path holds none, so one that appears was
/// put there after the path was checked, and opening fails. Not to wait for a pipe's other end: O_NONBLOCK.
Handle OpenCanonical(const fs::path& canonical) {
  Handle folder(open("/", folder_flags));
  for (const fs::path& part : canonical.parent_path().relative_path()) {
    if (!folder.IsOpen()) break;
    folder = Handle(openat(folder.Number(), part.c_str(), folder_flags));
  }
  if (!folder.IsOpen()) return folder;
  return Handle(
      openat(folder.Number(), canonical.filename().c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_NOCTTY | O_CLOEXEC));
}

/// Says what a path is when it is no regular file.
std::optional<std::string> WhyNotRegular(mode_t mode) {
  if (S_ISREG(mode)) return {};
  if (S_ISDIR(mode)) return "is a folder";
  if (S_ISFIFO(mode)) return "is a pipe, not a regular file";
  return "is a device, not a regular file";
}

void CheckRegular(const struct stat& status, const std::string& shown) {
  if (const auto why = WhyNotRegular(status.st_mode)) throw FileError{QuotedPath(shown) + " " + *why, {}};
}

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

std::string ReadAll(const Handle& handle, const struct stat& status, const std::string& shown) {
  std::string bytes;
  // The size is a hint only: a file may grow or shrink while it is read.
  bytes.resize(std::min(static_cast<std::size_t>(status.st_size), Files::max_bytes) + 1);
  std::size_t filled = 0;
  for (;;) {
    const ssize_t count = read(handle.Number(), bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw FileError{"cannot read " + QuotedPath(shown) + ": " + Reason(errno), {}};
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
    if (filled > Files::max_bytes) throw FileError{QuotedPath(shown) + " exceeds the limit of 1 GiB", {}};
    if (filled == bytes.size()) bytes.resize(std::min(2 * bytes.size(), Files::max_bytes + 1));
  }
  bytes.resize(filled);
  return bytes;
}

constexpr std::string_view one_up = "../";

/// A hint, or none.
std::string Meaning(const std::string& file) { return file.empty() ? "" : "did you mean " + Quoted(file) + "?"; }

}  // namespace

const std::string& StandardInput() {
  static const std::string text = [] {
    struct stat status {};
    const Handle handle(dup(STDIN_FILENO));
    if (!handle.IsOpen() || fstat(handle.Number(), &status) != 0)
      throw FileError{"cannot read standard input: " + Reason(errno), {}};
    return ReadAll(handle, status, standard_input_name);
  }();
  return text;
}

Files::Files(const std::string& top_scene, const std::vector<std::string>& allowed_folders)
    : top_(top_scene == "-" ? standard_input_name : top_scene) {
  for (const fs::path& folder : {fs::path(top_).parent_path(), fs::path(".")})
    if (auto root = CanonicalFolder(folder)) roots_.push_back(std::move(*root));
  for (const std::string& folder : allowed_folders) {
    auto root = CanonicalFolder(folder);
    // Else it would be allowed without a word, and its files be refused.
    if (!root) throw FileError{"-allow_path " + QuotedPath(folder) + ": there is no such folder", {}};
    if (!fs::is_directory(*root)) throw FileError{"-allow_path " + QuotedPath(folder) + ": it is no folder", {}};
    roots_.push_back(std::move(*root));
  }
}

FoundFile Files::Top() const {
  if (IsStandardInput()) return {top_, top_};
  std::error_code error;
  const fs::path canonical = fs::canonical(top_, error);
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
  if (file.canonical == standard_input_name) return StandardInput();
  // Asked before opening, because opening a device may do something; asked of the handle, because only that is certain.
  struct stat status {};
  if (stat(file.canonical.c_str(), &status) == 0) CheckRegular(status, file.shown);
  const Handle handle = OpenCanonical(file.canonical);
  if (!handle.IsOpen()) throw FileError{"cannot open " + Quoted(file.shown) + ": " + Reason(errno), {}};
  if (fstat(handle.Number(), &status) != 0)
    throw FileError{"cannot read " + Quoted(file.shown) + ": " + Reason(errno), {}};
  CheckRegular(status, file.shown);
  return ReadAll(handle, status, file.shown);
}

bool Files::IsAllowed(const std::string& canonical) const {
  return std::any_of(roots_.begin(), roots_.end(), [&](const std::string& root) { return IsBelow(canonical, root); });
}

}  // namespace ray
