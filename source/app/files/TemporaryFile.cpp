#include "source/app/files/TemporaryFile.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "source/app/Interrupt.h"

namespace ray {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void ThrowErrno() { throw std::system_error(errno, std::generic_category()); }

fs::path Folder(const fs::path& target) { return target.has_parent_path() ? target.parent_path() : fs::path("."); }

/// Returns ".out.jpg.raypro-", the common prefix of the temporary files of a target. Very long names are truncated. Two
/// targets with a common prefix do no harm, since only abandoned files are removed.
std::string Prefix(const fs::path& target) {
  constexpr std::size_t longest = 200;  // of the 255 bytes that file systems allow
  return "." + target.filename().string().substr(0, longest) + ".raypro-";
}

constexpr const char* suffix = ".tmp";

/// Flushes the folder to the disk, without which a rename does not survive a crash of the computer. Some file systems
/// cannot sync a folder; the image is in place by then, so that is not a failure.
void SyncFolder(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

/// Returns true if the name still refers to the open file. Allocates nothing: a new file must not be left behind
/// because memory ran out.
bool IsNameOf(const char* file, int descriptor) {
  struct stat named = {}, opened = {};
  return lstat(file, &named) == 0 && fstat(descriptor, &opened) == 0 && named.st_dev == opened.st_dev &&
         named.st_ino == opened.st_ino;
}

// A writer holds the lock of its file from before the first byte until the rename. So a file that can be locked and
// still has its name is abandoned, or so new that its creator is waiting for the lock and will see that the name is
// gone.
void RemoveIfDead(const std::string& file) {
  const int descriptor = open(file.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 && IsNameOf(file.c_str(), descriptor)) unlink(file.c_str());
  close(descriptor);
}

std::optional<struct stat> StatusOfFile(const fs::path& file) {
  struct stat status = {};
  if (stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return {};
  return status;
}

/// Gives an open file the owner, the group and the mode bits of another. Only the superuser may change the owner, and
/// others may only choose one of their own groups; if the group cannot be set, it gets only the permissions of others.
/// File systems without permissions are not an error.
void Resemble(int descriptor, const struct stat& other) {
  constexpr auto unchanged = static_cast<uid_t>(-1);
  mode_t mode = other.st_mode & 0777;
  const bool has_its_group =
      fchown(descriptor, other.st_uid, other.st_gid) == 0 || fchown(descriptor, unchanged, other.st_gid) == 0;
  if (!has_its_group) mode &= ~mode_t{070} | (mode & 07) << 3;
  fchmod(descriptor, mode);
}

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& target, const fs::path& replaced) : target_(target) {
  const auto before = StatusOfFile(replaced);
  // Nobody else may read it before its final permissions are set.
  const unsigned mode = before ? 0600 : 0666;
  const std::string start = (Folder(target) / Prefix(target)).string() + std::to_string(getpid());
  name_ = start + suffix;
  // The name is taken if a process with the same number works on the same folder in another container.
  constexpr int most_attempts = 100;
  for (int attempt = 2; !CreateAndLock(mode); ++attempt) {
    if (attempt > most_attempts) ThrowErrno();
    name_ = start + "-" + std::to_string(attempt) + suffix;
  }
  if (before) Resemble(descriptor_, *before);
}

// Returns false if the name is taken. On file systems without locks, nobody can remove the file as abandoned either.
bool TemporaryFile::CreateAndLock(unsigned mode) {
  descriptor_ = open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (descriptor_ < 0 && errno == EEXIST) return false;
  if (descriptor_ < 0) ThrowErrno();
  flock(descriptor_, LOCK_EX);
  // Between the two calls another process may have found it unlocked, and removed it.
  if (IsNameOf(name_.c_str(), descriptor_)) {
    RemoveWhenKilled(name_.c_str());
    return true;
  }
  Close(std::exchange(descriptor_, -1));
  errno = EEXIST;
  return false;
}

TemporaryFile::~TemporaryFile() {
  if (!name_.empty()) unlink(name_.c_str());
  RemoveWhenKilled(nullptr);
  if (descriptor_ >= 0) close(descriptor_);
}

void TemporaryFile::Write(std::span<const unsigned char> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) ThrowErrno();
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void TemporaryFile::Become() {
  // EINVAL: this file system has nothing to flush.
  if (fsync(descriptor_) != 0 && errno != EINVAL) ThrowErrno();
  // Closing must be checked before the rename, but would release the lock. Copies of a descriptor share the lock.
  const int copy = dup(descriptor_);
  if (copy < 0) ThrowErrno();
  Close(std::exchange(descriptor_, copy));
  if (rename(name_.c_str(), target_.c_str()) != 0) ThrowErrno();
  RemoveWhenKilled(nullptr);
  name_.clear();
  SyncFolder(Folder(target_));
}

// Closing can report a delayed write error, especially on network file systems.
void TemporaryFile::Close(int descriptor) {
  if (close(descriptor) != 0 && errno != EINTR) ThrowErrno();
}

void RemoveLeftOvers(const fs::path& target) {
  const std::string prefix = Prefix(target), folder = Folder(target).string();
  // std::filesystem's iterator would end the program if memory runs out.
  const std::unique_ptr<DIR, int (*)(DIR*)> listing(opendir(folder.c_str()), closedir);
  if (!listing) return;
  while (const dirent* entry = readdir(listing.get())) {
    const std::string_view name = entry->d_name;
    if (name.starts_with(prefix) && name.ends_with(suffix)) RemoveIfDead(folder + "/" + std::string(name));
  }
}

}  // namespace ray
