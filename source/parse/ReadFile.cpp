#include "source/parse/Files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "source/text/Quoting.h"

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

// Traversing a folder needs no permission to list it, on systems that distinguish the two.
#ifdef O_PATH
constexpr int folder_flags = O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
#else
constexpr int folder_flags = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
#endif

/// Opens a canonical path one folder at a time, without following links. A canonical path contains none, so a link that
/// appears was put there after the check, and opening fails. O_NONBLOCK avoids waiting for the other end of a pipe.
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

/// Returns the kind of a path that is not a regular file.
std::optional<std::string> WhyNotRegular(mode_t mode) {
  if (S_ISREG(mode)) return {};
  if (S_ISDIR(mode)) return "is a folder";
  if (S_ISFIFO(mode)) return "is a pipe, not a regular file";
  return "is a device, not a regular file";
}

void CheckRegular(const struct stat& status, const std::string& shown) {
  if (const auto why = WhyNotRegular(status.st_mode)) throw FileError{QuotedPath(shown) + " " + *why, {}};
}

std::string ReadAll(const Handle& handle, const struct stat& status, const std::string& shown) {
  std::string bytes;
  // The size is only a hint: a file may grow or shrink while it is read.
  bytes.resize(std::min(static_cast<std::size_t>(status.st_size), Files::max_bytes) + 1);
  std::size_t length = 0;
  for (;;) {
    const ssize_t count = read(handle.Number(), bytes.data() + length, bytes.size() - length);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw FileError{"cannot read " + QuotedPath(shown) + ": " + Reason(errno), {}};
    if (count == 0) break;
    length += static_cast<std::size_t>(count);
    if (length > Files::max_bytes) throw FileError{QuotedPath(shown) + " exceeds the limit of 1 GiB", {}};
    if (length == bytes.size()) bytes.resize(std::min(2 * bytes.size(), Files::max_bytes + 1));
  }
  bytes.resize(length);
  return bytes;
}

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

std::string ReadFile(const FoundFile& file) {
  // Checked before opening, because opening a device may have effects, and again on the handle, because only that is
  // certain.
  struct stat status {};
  if (stat(file.canonical.c_str(), &status) == 0) CheckRegular(status, file.shown);
  const Handle handle = OpenCanonical(file.canonical);
  if (!handle.IsOpen()) throw FileError{"cannot open " + Quoted(file.shown) + ": " + Reason(errno), {}};
  if (fstat(handle.Number(), &status) != 0)
    throw FileError{"cannot read " + Quoted(file.shown) + ": " + Reason(errno), {}};
  CheckRegular(status, file.shown);
  return ReadAll(handle, status, file.shown);
}

}  // namespace ray
