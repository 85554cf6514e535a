#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ray::grade {

/// What a program may take.
struct Limits {
  double seconds = 10;
  double memory = 768;                              // MiB of addresses, of each process
  int processes = 64;                               // threads count as processes
  std::int64_t file_bytes = std::int64_t{1} << 28;  // of each file that it writes
  std::int64_t output_bytes = std::int64_t{1} << 24;
};

/// How a program ended.
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
  double seconds = 0;  // of the clock
  std::string output;  // the beginning of what it printed
  std::string reason;  // why there is no program, or which limit was reached

  bool IsGood() const { return end == End::exited && status == 0; }
  /// One or two words for tables: "time-out", "crash"; empty if it is good.
  const char* Note() const;
  /// Completes "The program": "was stopped after 10 s", "crashed: segmentation fault (signal 11)"; empty if it is good.
  std::string Problem() const;
};

/// The folders in which programs named without a slash are looked for, whatever the user's own PATH is.
inline constexpr std::array program_folders{"/usr/local/bin", "/usr/bin", "/bin"};
/// The user that programs run as if the grader is the superuser: one that nobody else is, since a limit on processes
/// counts all that a user has.
inline constexpr unsigned sandbox_user = 61184;

/// Runs programs that nobody vouches for: with bubblewrap in namespaces of their own, where they see system folders
/// and their own files only and have no network; where that cannot be, with limits alone. Whatever they started has
/// ended when they have.
class Sandbox {
 public:
  enum class Mode { automatic, bubblewrap, limits };

  /// Finds out what works here. Throws std::runtime_error where bubblewrap is asked for and does not.
  explicit Sandbox(Mode mode);

  bool IsolatesPrograms() const { return has_bubblewrap_; }
  /// One line for teachers: how programs are run, and what that does not keep them from.
  std::string Describe() const;

  /// Runs a command in `folder`, the only one that it may write to, which must exist; files that the words name may be
  /// read, with all beside them, and those of `readable`.
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
