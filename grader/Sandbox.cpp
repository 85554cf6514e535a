#include "grader/Sandbox.h"

#include <fcntl.h>
#include <grp.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <set>
#include <stdexcept>
#include <thread>

#include "source/text/NumberText.h"
#include "source/text/Words.h"

namespace ray::grade {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t most_kept_output = 16384;  // bytes
constexpr double cpu_seconds_per_second = 4;  // of several threads together

bool IsSuperuser() { return geteuid() == 0; }

double SecondsSince(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// Returns the number of this user's threads, since the limit counts them all.
rlim_t ThreadsOfUser() {
  rlim_t count = 0;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/proc", ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    struct stat status {};
    if (stat(entry.path().c_str(), &status) != 0 || status.st_uid != geteuid()) continue;
    for (const auto& thread : fs::directory_iterator(entry.path() / "task", ignored)) count += thread.exists() ? 1 : 0;
  }
  return count;
}

void Limit(int resource, rlim_t most, rlim_t hard) {
  const rlimit limit{most, hard};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}
void Limit(int resource, rlim_t most) { Limit(resource, most, most); }

rlim_t CpuSeconds(const Limits& limits) {
  return static_cast<rlim_t>(std::ceil(cpu_seconds_per_second * limits.seconds)) + 1;
}

rlim_t MemoryBytes(const Limits& limits) { return static_cast<rlim_t>(limits.memory * 1024 * 1024); }

/// Runs in the child, before it becomes the program.
void ApplyLimits(const Limits& limits) {
  Limit(RLIMIT_CORE, 0);
  Limit(RLIMIT_FSIZE, static_cast<rlim_t>(limits.file_bytes));
  Limit(RLIMIT_CPU, CpuSeconds(limits), CpuSeconds(limits) + 1);  // SIGXCPU, which has a reason, before SIGKILL
  Limit(RLIMIT_AS, MemoryBytes(limits));
}

struct Pipe {
  Pipe() {
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe can be made");
  }
  ~Pipe() {
    for (const int end : ends)
      if (end >= 0) close(end);
  }
  void CloseWriting() {
    close(ends[1]);
    ends[1] = -1;
  }
  int ends[2];
};

/// Returns the children of a process.
std::vector<pid_t> ChildrenOf(pid_t process) {
  std::ifstream list("/proc/" + std::to_string(process) + "/task/" + std::to_string(process) + "/children");
  std::vector<pid_t> children;
  for (pid_t child; list >> child;) children.push_back(child);
  return children;
}

/// Kills the process and its descendants. They are stopped first, so that none starts others meanwhile.
void KillTree(pid_t process) {
  std::vector<pid_t> all{process};
  for (std::size_t i = 0; i < all.size(); ++i) {
    kill(all[i], SIGSTOP);
    const auto children = ChildrenOf(all[i]);
    all.insert(all.end(), children.begin(), children.end());
  }
  for (const pid_t each : all) kill(each, SIGKILL);
}

/// Kills processes that the program left behind. Their parent is this process, which has requested that.
void KillOrphans(const std::set<pid_t>& earlier) {
  for (int round = 0; round < 200; ++round) {
    bool is_any = false;
    for (const pid_t child : ChildrenOf(getpid())) {
      if (earlier.contains(child)) continue;
      is_any = true;
      KillTree(child);
      waitpid(child, nullptr, WNOHANG);
    }
    if (!is_any) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

/// A program with its arguments and its environment, as the system takes them.
struct Command {
  Command(const std::vector<std::string>& its_words, const fs::path& folder)
      : words(its_words),
        variables{Path(), "HOME=" + folder.string(), "TMPDIR=" + folder.string(),
                  "LANG=C.UTF-8"},
        arguments(Pointers(words)),
        environment(Pointers(variables)) {}
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  static std::string Path() {
    std::string path;
    for (const char* place : program_folders) path += (path.empty() ? "PATH=" : ":") + std::string(place);
    return path;
  }
  static std::vector<char*> Pointers(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
  }

  std::vector<std::string> words, variables;
  std::vector<char*> arguments, environment;
};

/// Writes to the output without allocating.
void Say(const char* text) {
  if (write(STDOUT_FILENO, text, std::strlen(text)) < 0) _exit(126);
}

/// Runs in the child. It allocates nothing: the grader may already use more memory than the limit allows, so that any
/// further allocation would fail, and the program would be reported as crashed.
[[noreturn]] void BecomeProgram(const Command& command, const fs::path& folder, const Limits& limits, int output,
                                bool is_wrapped, rlim_t processes) {
  setsid();
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // so that it does not outlive a grader that is killed
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, 0);
  dup2(output, 1);
  dup2(output, 2);
  if (chdir(folder.c_str()) != 0) _exit(126);
  if (!is_wrapped) ApplyLimits(limits);
  if (!is_wrapped) Limit(RLIMIT_NPROC, processes);
  if (!is_wrapped && IsSuperuser() &&
      (setgroups(0, nullptr) != 0 || setgid(sandbox_user) != 0 || setuid(sandbox_user) != 0))
    _exit(126);
  execvpe(command.arguments[0], command.arguments.data(), command.environment.data());
  const char* const why = std::strerror(errno);  // allocates for unknown errors only
  for (const char* text : {"cannot run ", static_cast<const char*>(command.arguments[0]), ": ", why, "\n"}) Say(text);
  _exit(127);
}

/// Reads until the program has ended; stops it if it takes too long or prints too much.
class Watch {
 public:
  Watch(pid_t process, int output, const Limits& limits, const std::atomic<bool>* stop)
      : process_(process), output_(output), limits_(limits), stop_(stop) {}

  RunResult Wait() {
    int wait_status = 0;
    for (;;) {
      const bool has_ended = waitpid(process_, &wait_status, WNOHANG) == process_;
      if (!has_ended) SampleMemory();
      ReadWhatIsThere(has_ended ? 0 : 5);
      if (has_ended) break;
      if (SecondsSince(begin_) > limits_.seconds) return Stopped(RunResult::End::timed_out);
      if (stop_ && *stop_) return Stopped(RunResult::End::interrupted);
      if (read_ > limits_.output_bytes) return Stopped(RunResult::End::too_much_output);
    }
    result_.seconds = SecondsSince(begin_);
    result_.end = WIFEXITED(wait_status) ? RunResult::End::exited : RunResult::End::signaled;
    result_.status = WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : WTERMSIG(wait_status);
    return result_;
  }

  /// Returns the largest address space of a process of the program that was observed, in MiB.
  double PeakMemory() const { return peak_; }

 private:
  RunResult Stopped(RunResult::End how) {
    KillTree(process_);
    waitpid(process_, nullptr, 0);
    result_.seconds = SecondsSince(begin_);
    result_.end = how;
    return result_;
  }

  /// Reads /proc, since wait4 reports nothing about programs that bubblewrap starts.
  void SampleMemory() {
    constexpr double seconds_between = 0.02;
    if (SecondsSince(sampled_) < seconds_between) return;
    sampled_ = Clock::now();
    std::vector<pid_t> all{process_};
    // processes: more than any program needs, except a fork bomb
    constexpr std::size_t most = 100;
    for (std::size_t i = 0; i < all.size() && all.size() < most; ++i) {
      const auto children = ChildrenOf(all[i]);
      all.insert(all.end(), children.begin(), children.end());
      std::ifstream pages("/proc/" + std::to_string(all[i]) + "/statm");
      double count = 0;
      if (pages >> count) peak_ = std::max(peak_, count * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 20));
    }
  }

  void ReadWhatIsThere(int milliseconds) {
    pollfd wanted{output_, POLLIN, 0};
    if (is_closed_) std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    if (is_closed_ || poll(&wanted, 1, milliseconds) <= 0) return;
    std::array<char, 65536> bytes;
    const ssize_t count = read(output_, bytes.data(), bytes.size());
    if (count <= 0) {
      is_closed_ = true;
      return;
    }
    read_ += count;
    const std::size_t room = most_kept_output - std::min(most_kept_output, result_.output.size());
    result_.output.append(bytes.data(), std::min(room, static_cast<std::size_t>(count)));
  }

  pid_t process_;
  int output_;
  const Limits& limits_;
  const std::atomic<bool>* stop_;
  RunResult result_;
  Clock::time_point begin_ = Clock::now();
  std::int64_t read_ = 0;
  bool is_closed_ = false;
  double peak_ = 0;
  Clock::time_point sampled_ = begin_;
};

// Messages of language runtimes and tools when an allocation fails.
constexpr std::array signs_of_no_memory{
    "bad_alloc",        "MemoryError", "annot allocate memory", "ut of memory",   "OutOfMemory",
    "memory exhausted", "heap limit",  "memory allocation of",  "emory capacity", "not enough memory"};

bool HasUsedUpMemory(const RunResult& result, double peak, const Limits& limits) {
  constexpr double nearly = 0.8;  // of the limit: a program may grow by the rest between two samples
  return peak > nearly * limits.memory || std::ranges::any_of(signs_of_no_memory, [&](const char* sign) {
           return result.output.find(sign) != std::string::npos;
         });
}

/// Returns the system's reason if `output` says that a program could not be executed: the words of BecomeProgram, or
/// those of prlimit within bubblewrap.
std::string WhyNotExecuted(const std::string& output, const std::string& program) {
  for (const std::string& begin : {"cannot run " + program + ": ", "prlimit: failed to execute " + program + ": "})
    if (output.starts_with(begin)) return output.substr(begin.size(), output.find('\n') - begin.size());
  return {};
}

std::string NoProgram(const std::string& program, const std::string& why) {
  std::error_code none;
  const bool is_there = program.find('/') != std::string::npos && fs::exists(program, none);
  if (why == std::strerror(ENOENT) && is_there)
    return program + " exists, but the interpreter that its first line names, or a library, does not";
  if (why == std::strerror(EACCES))
    return program + ": " + why + "; it must be executable" +
           (IsSuperuser() ? ", and readable for user " + std::to_string(sandbox_user) : "");
  return program + ": " + why;
}

/// Replaces an exit status or a signal by its reason: no program, or a limit that was reached.
void FindReason(RunResult& result, const std::string& program, double peak, const Limits& limits) {
  using enum RunResult::End;
  if (result.IsGood() || (result.end != exited && result.end != signaled)) return;
  const std::string why = result.end == exited ? WhyNotExecuted(result.output, program) : "";
  const bool has_signal = result.end == signaled;
  if (!why.empty()) {
    result.end = no_program;
    result.reason = NoProgram(program, why);
  } else if (has_signal && result.status == SIGXCPU) {
    result.end = out_of_cpu;
    result.reason = std::to_string(CpuSeconds(limits)) + " s";
  } else if (has_signal && result.status == SIGXFSZ) {
    result.end = large_file;
    result.reason = std::to_string(limits.file_bytes >> 20) + " MiB";
  } else if (HasUsedUpMemory(result, peak, limits)) {
    result.end = out_of_memory;
    result.reason = Rounded(limits.memory, 6) + " MiB";
  }
}

/// Runs a command.
///   program   the student's own, which `words` may wrap
RunResult RunWords(const std::vector<std::string>& words, const std::string& program, const fs::path& folder,
                   const Limits& limits, bool is_wrapped, const std::atomic<bool>* stop) {
  Pipe pipe;
  const Command command(words, folder);
  const rlim_t processes = static_cast<rlim_t>(limits.processes) + (IsSuperuser() ? 0 : ThreadsOfUser());
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  const auto children = ChildrenOf(getpid());
  const std::set<pid_t> earlier(children.begin(), children.end());
  const pid_t process = fork();
  if (process < 0) return {};
  if (process == 0) BecomeProgram(command, folder, limits, pipe.ends[1], is_wrapped, processes);
  pipe.CloseWriting();
  Watch watch(process, pipe.ends[0], limits, stop);
  RunResult result = watch.Wait();
  KillOrphans(earlier);
  // The wrapper reports a signal as shells do.
  constexpr int shells_signal = 128;
  if (is_wrapped && result.end == RunResult::End::exited && result.status > shells_signal &&
      result.status < shells_signal + SIGRTMIN) {
    result.end = RunResult::End::signaled;
    result.status -= shells_signal;
  }
  FindReason(result, program, watch.PeakMemory(), limits);
  return result;
}

/// Folders of a system that programs of any kind need.
constexpr std::array system_folders{"/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/opt"};
constexpr std::array system_files{"/etc/alternatives", "/etc/ld.so.cache", "/etc/ld.so.conf", "/etc/ld.so.conf.d",
                                  "/etc/localtime", "/etc/ssl/openssl.cnf"};

bool IsOfSystem(const fs::path& path) {
  return std::ranges::any_of(system_folders,
                             [&](const char* folder) { return path.string().starts_with(std::string(folder) + "/"); });
}

/// Returns the folder of each file that a word of the command names; for a folder the folder itself.
std::vector<fs::path> FoldersOf(const std::vector<std::string>& command) {
  std::vector<fs::path> folders;
  for (const std::string& word : command) {
    std::error_code failed;
    const fs::path path = fs::canonical(word, failed);
    if (failed) continue;
    const fs::path folder = fs::is_directory(path, failed) ? path : path.parent_path();
    folders.push_back(folder == folder.root_path() ? path : folder);
    // A link, such as the python3 of a virtual environment, is run by its own name.
    if (fs::is_symlink(word, failed)) folders.push_back(fs::canonical(fs::path(word).parent_path(), failed));
  }
  std::erase_if(folders, [](const fs::path& folder) { return folder.empty() || IsOfSystem(folder / ""); });
  return folders;
}

/// Returns the arguments with which bubblewrap shows the system's folders and files, read-only.
std::vector<std::string> SystemMounts() {
  std::vector<std::string> words;
  const auto add = [&](std::initializer_list<std::string> more) { words.insert(words.end(), more); };
  for (const char* system : system_folders) {
    std::error_code ignored;
    if (fs::is_symlink(system, ignored))
      add({"--symlink", fs::read_symlink(system, ignored).string(), system});
    else
      add({"--ro-bind-try", system, system});
  }
  // Folders that bubblewrap creates on the way to a file are accessible to its own user only, by default.
  add({"--perms", "0755", "--dir", "/etc", "--perms", "0755", "--dir", "/etc/ssl"});
  for (const char* file : system_files) add({"--ro-bind-try", file, file});
  return words;
}

/// Returns the arguments with which bubblewrap shows a path in its place; `how` decides whether it is writable.
std::vector<std::string> Mount(const char* how, const fs::path& path) {
  std::vector<std::string> words;
  fs::path parent;
  for (const fs::path& part : path.parent_path()) {
    parent /= part;
    if (parent != path.root_path()) words.insert(words.end(), {"--perms", "0755", "--dir", parent.string()});
  }
  words.insert(words.end(), {how, path.string(), path.string()});
  return words;
}

/// Returns the arguments that drop all rights; a superuser becomes an otherwise unused user.
std::vector<std::string> DroppedRights() {
  if (!IsSuperuser()) return {"--unshare-user", "--cap-drop", "ALL", "--"};
  const std::string user = std::to_string(sandbox_user);
  return {"--cap-drop",      "ALL",           "--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID",
          "--cap-add",       "CAP_SETPCAP",   "--",        "setpriv",    "--reuid",   user,
          "--regid",         user,            "--clear-groups", "--no-new-privs", "--bounding-set", "-all",
          "--inh-caps",      "-all"};
}

/// Returns the arguments that set limits on a program's processes, time, files and memory.
std::vector<std::string> LimitWords(const Limits& limits) {
  return {"prlimit",
          "--core=0",
          "--nproc=" + std::to_string(limits.processes),
          "--cpu=" + std::to_string(CpuSeconds(limits)) + ":" + std::to_string(CpuSeconds(limits) + 1),
          "--fsize=" + std::to_string(limits.file_bytes),
          "--as=" + std::to_string(MemoryBytes(limits)),
          "--"};
}

}  // namespace

std::string RunResult::Problem() const {
  switch (end) {
    case End::exited:
      return status == 0 ? "" : "ended with exit status " + std::to_string(status);
    case End::signaled:
      if (status == SIGKILL) return "was killed (signal 9) by another program, or because the machine is out of memory";
      return "crashed: " + std::string(strsignal(status)) + " (signal " + std::to_string(status) + ")";
    case End::no_program:
      return "cannot be run: " + reason;
    case End::out_of_memory:
      return "ran out of memory: the limit is " + reason;
    case End::out_of_cpu:
      return "was stopped after " + reason + " of processor time";
    case End::large_file:
      return "was stopped when it wrote a file of more than " + reason;
    case End::timed_out:
      return "was stopped after " + Rounded(seconds, 3) + " s";
    case End::too_much_output:
      return "was stopped because it printed without end";
    case End::interrupted:
      return "was stopped because the grader was";
    case End::not_started:
      return "could not be started";
  }
  return {};
}

const char* RunResult::Note() const {
  switch (end) {
    case End::exited:
      return status == 0 ? "" : "exit status";
    case End::signaled:
      return status == SIGKILL ? "killed" : "crash";
    case End::timed_out:
    case End::out_of_cpu:
      return "time-out";
    case End::too_much_output:
      return "endless output";
    case End::interrupted:
      return "interrupted";
    case End::not_started:
    case End::no_program:
      return "no program";
    case End::out_of_memory:
      return "out of memory";
    case End::large_file:
      return "large file";
  }
  return "";
}

Sandbox::Sandbox(Mode mode) {
  if (mode == Mode::limits) {
    why_not_ = "as requested";
    return;
  }
  has_bubblewrap_ = true;
  const RunResult tried = Run({"/bin/true"}, fs::temp_directory_path(), {}, {.seconds = 5});
  if (tried.IsGood()) return;
  has_bubblewrap_ = false;
  why_not_ = tried.output.substr(0, tried.output.find('\n'));
  if (tried.end == RunResult::End::exited && tried.output.starts_with("cannot run bwrap"))
    why_not_ = "bubblewrap is not installed";
  if (mode == Mode::bubblewrap) throw std::runtime_error("bubblewrap does not work here: " + why_not_);
}

std::string Sandbox::Describe() const {
  if (has_bubblewrap_) return "programs run in a sandbox (bubblewrap), without network";
  return "no sandbox (" + why_not_ +
         "): programs have limits on time, memory and processes, but can read files of this machine and use the "
         "network";
}

std::vector<std::string> Sandbox::Wrapped(const std::vector<std::string>& command, const fs::path& folder,
                                          const std::vector<fs::path>& readable, const Limits& limits) const {
  std::vector<std::string> words{
      "bwrap",         "--unshare-pid", "--unshare-net", "--unshare-ipc", "--unshare-uts", "--die-with-parent",
      "--new-session", "--proc",        "/proc",         "--dev",         "/dev",          "--tmpfs",
      "/tmp"};
  const auto add = [&](const std::vector<std::string>& more) { words.insert(words.end(), more.begin(), more.end()); };
  add(SystemMounts());
  for (const fs::path& path : FoldersOf(command)) add(Mount("--ro-bind", path));
  for (const fs::path& path : readable) add(Mount("--ro-bind", path));
  add(Mount("--bind", folder));
  add({"--chdir", folder.string()});
  add(DroppedRights());
  add(LimitWords(limits));
  add(command);
  return words;
}

RunResult Sandbox::Run(const std::vector<std::string>& command, const fs::path& folder,
                       const std::vector<fs::path>& readable, const Limits& limits,
                       const std::atomic<bool>* stop) const {
  return RunWords(has_bubblewrap_ ? Wrapped(command, folder, readable, limits) : command, command.front(), folder,
                  limits, has_bubblewrap_, stop);
}

}  // namespace ray::grade
