#pragma once

#include <filesystem>
#include <span>
#include <string>

namespace ray {

/// A file beside `target` that becomes it when it is whole, ".out.jpg.raypro-1234.tmp". While it is being written it is
/// locked, so that another process can tell it from what a killed one left behind. Everything throws std::system_error.
class TemporaryFile {
 public:
  /// Its mode bits, and where the system permits its owner and group, are those of the file that it replaces, so that
  /// an image that others may not read stays so after the next render. Without such a file they are those of any new
  /// file: 666 less the umask.
  explicit TemporaryFile(const std::filesystem::path& target) : TemporaryFile(target, target) {}
  /// For a target that takes the place of another file, `replaced`.
  TemporaryFile(const std::filesystem::path& target, const std::filesystem::path& replaced);
  ~TemporaryFile();  // removes the file, unless it has become the target
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// When it was created, or last written to, by the clock of its file system.
  std::filesystem::file_time_type Time() const { return std::filesystem::last_write_time(name_); }
  void Write(std::span<const unsigned char> bytes);
  /// Flushes it to the disk and renames it; the target is at every moment its old self or the new one.
  void Become();

 private:
  bool CreateAndLock(unsigned mode);
  static void Close(int descriptor);

  std::filesystem::path target_;
  std::string name_;
  int descriptor_ = -1;
};

/// Removes what killed processes left beside the target; throws nothing but std::bad_alloc.
void RemoveLeftOvers(const std::filesystem::path& target);

}  // namespace ray
