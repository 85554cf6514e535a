#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace ray {

/// A file next to `target` that replaces it when it is complete, ".out.jpg.raypro-1234.tmp". While it is being written
/// it is locked, so that other processes can distinguish it from files left by killed ones. All functions throw
/// std::system_error.
class TemporaryFile {
 public:
  /// Creates the file. Its mode bits and, if the system permits, its owner and group are those of the file that it
  /// replaces, so that an image that others may not read stays private after the next render. Without such a file they
  /// are the usual ones: 666 minus the umask.
  explicit TemporaryFile(const std::filesystem::path& target) : TemporaryFile(target, target) {}
  /// Creates the file for a target that takes the place of another file, `replaced`.
  TemporaryFile(const std::filesystem::path& target, const std::filesystem::path& replaced);
  ~TemporaryFile();  // removes the file, unless it has become the target
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// Returns the time of its creation or last write, by the clock of its file system.
  std::filesystem::file_time_type Time() const { return std::filesystem::last_write_time(name_); }
  void Write(std::span<const unsigned char> bytes);
  /// Flushes it to the disk and renames it; the target is always either the old or the new file.
  void Become();

 private:
  bool CreateAndLock(unsigned mode);
  static void Close(int descriptor);

  std::filesystem::path target_;
  std::string name_;
  int descriptor_ = -1;
};

/// Removes the temporary files that killed processes left next to the target; throws only std::bad_alloc.
void RemoveLeftOvers(const std::filesystem::path& target);

}  // namespace ray
