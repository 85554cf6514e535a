#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ray::grade {

/// The resource limits of a program.
struct Limits {
  double seconds = 10;
  double memory = 768;                              // MiB of address space, of each process
  int processes = 64;                               // threads count as processes
  std::int64_t file_bytes = std::int64_t{1} << 28;  // of each file that it writes
  std::int64_t output_bytes = std::int64_t{1} << 24;
};

/// The end of a program.
struct RunResult {
  enum class End {
    exited,
    signaled,
    timed_out,
    too_much_output,
    interrupted,
    not_started,
    no_program,     // the system could not run the command's first word
    out_of_memory,  // it reached its limit, judging by its output or its size
    out_of_cpu,     // its threads used up their processor time
    large_file
  };

  End end = End::not_started;
  int status = 0;      // exit status, or the signal's number
  double seconds = 0;  // wall-clock time
  std::string output;  // the beginning of its output
  std::string reason;  // why there is no program, or which limit was reached

  bool IsGood() const { return end == End::exited && status == 0; }
  /// Returns one or two words for tables: "time-out", "crash"; empty if it succeeded.
  const char* Note() const;
  /// Returns text that completes "The program": "was stopped after 10 s", "crashed: segmentation fault (signal 11)";
  /// empty if it succeeded.
  std::string Problem() const;
};

/// The folders in which programs named without a slash are searched, regardless of the user's own PATH.
inline constexpr std::array program_folders{"/usr/local/bin", "/usr/bin", "/bin"};
/// The user that programs run as if the grader is the superuser. No other process uses it, since a limit on processes
/// counts all processes of a user.
inline constexpr unsigned sandbox_user = 61184;

/// Runs untrusted programs: with bubblewrap in separate namespaces, where they see only system folders and their own
/// files and have no network; if that is impossible, with limits alone. All processes that they started have ended when
/// they have.
class Sandbox {
 public:
  enum class Mode { automatic, bubblewrap, limits };

  /// Determines what works here. Throws std::runtime_error if bubblewrap is requested and does not work.
  explicit Sandbox(Mode mode);

  bool IsolatesPrograms() const { return has_bubblewrap_; }
  /// Returns one line for teachers: how programs are run, and the remaining risks.
  std::string Describe() const;

  /// Runs a command in `folder`, the only one that it may write to, which must exist. Files that the words name may be
  /// read, with all files in their folders, and those of `readable`.
  ///   stop   ends the program when it becomes true; may be null
  RunResult Run(const std::vector<std::string>& command, const std::filesystem::path& folder,
                const std::vector<std::filesystem::path>& readable, const Limits& limits,
                const std::atomic<bool>* stop = nullptr) const;

 private:
  std::vector<std::string> Wrapped(const std::vector<std::string>& command, const std::filesystem::path& folder,
                                   const std::vector<std::filesystem::path>& readable, const Limits& limits) const;

  bool has_bubblewrap_ = false;
  std::string why_not_;
};

}  // namespace ray::grade
