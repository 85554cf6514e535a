#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <string>

#include "source/view/LatestJob.h"
#include "source/inspect/LoadedScene.h"

namespace ray {

/// Reads scenes in the background, so that the window answers meanwhile.
class SceneReader {
 public:
  using Show = std::function<void(std::shared_ptr<const LoadedScene>)>;
  using Refuse = std::function<void(const std::exception&)>;

  /// Begins to read a scene in place of the one that is being read. Then, in the thread that calls Update, calls `show`
  /// with it, or `refuse` with the error of reading or of `show`.
  ///   is_edit  the scene has unsaved changes, which are lost if it is not shown
  void Read(const std::string& file, const ParseOptions& parse, const AcceleratorSettings& how, bool is_edit, Show show,
            Refuse refuse);
  /// Ends what has been read, or, if `waits`, what is being read.
  void Update(bool waits = false);

  void Stop() { job_.Drop(); }

  bool IsBusy() const { return job_.IsBusy(); }
  bool IsReadingEdit() const { return IsBusy() && is_edit_; }
  /// Returns the file that is being read, or was read last.
  const std::string& File() const { return file_; }
  /// Returns "reading city.scn, 3 s"; empty if nothing is being read.
  std::string Describe() const;
  /// Returns the duration of the last read that was shown, in seconds.
  double Seconds() const { return seconds_; }

 private:
  using Scene = std::shared_ptr<const LoadedScene>;

  LatestJob<Scene> job_;
  std::string file_;
  bool is_edit_ = false;
  Show show_;
  Refuse refuse_;
  std::chrono::steady_clock::time_point begin_;
  double seconds_ = 0;
};

}  // namespace ray
