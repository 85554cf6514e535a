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

std::string ReadAll(const Handle& handle, const struct stat& status, const std::string& shown) {
  std::string bytes;
  // The size is a hint only: a file may grow or shrink while it is read.
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

}  // namespace ray
