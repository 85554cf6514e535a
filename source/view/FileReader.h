#pragma once

#include <exception>
#include <functional>
#include <string>

#include "source/view/LatestJob.h"

namespace ray {

/// Reads files in the background, so that the window answers meanwhile: scenes, images, rays of another tracer.
class FileReader {
 public:
  /// Shows the file that was read.
  using Show = std::function<void()>;
  using Read = std::function<Show()>;
  using Refuse = std::function<void(const std::exception&)>;

  /// Begins to read a file in place of the one that is being read: calls `read` in another thread; then, in the thread
  /// that calls Update, what it returned, or `refuse` with the error of either.
  ///   is_edit  the file has unsaved changes, which are lost if it is not shown
  void Begin(const std::string& file, bool is_edit, Read read, Refuse refuse);
  /// Shows a file whose reading is complete; if `waits`, waits until it is.
  void Update(bool waits = false);

  void Stop() { job_.Drop(); }

  bool IsBusy() const { return job_.IsBusy(); }
  bool IsReadingEdit() const { return IsBusy() && is_edit_; }
  /// Returns the file that is being read, or was read last.
  const std::string& File() const { return file_; }
  /// Returns "reading city.scn, 3 s"; empty if nothing is being read.
  std::string Describe() const;
  /// Returns the duration of the last read, in seconds.
  double Seconds() const { return seconds_; }

 private:
  LatestJob<Show> job_;
  std::string file_;
  bool is_edit_ = false;
  Refuse refuse_;
  std::chrono::steady_clock::time_point begin_;
  double seconds_ = 0;
};

}  // namespace ray
