#include "tests/source/app/Program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace ray::testing {
namespace {

namespace fs = std::filesystem;

/// Everything of the child is made before the fork: after it, a process with threads must not allocate memory.
struct Prepared {
  std::vector<std::string> words, environment;
  std::vector<char*> word_pointers, environment_pointers;

  static std::vector<char*> Pointers(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    for (std::string& text : texts) pointers.push_back(text.data());
    pointers.push_back(nullptr);
    return pointers;
  }
};

Prepared Prepare(const std::vector<std::string>& words, const Surroundings& surroundings) {
  Prepared prepared;
  prepared.words = words;
  prepared.words.insert(prepared.words.begin(), ProgramName(surroundings.program));
  for (char** variable = environ; *variable; ++variable) {
    const std::string text = *variable;
    if (!surroundings.environment.contains(text.substr(0, text.find('=')))) prepared.environment.push_back(text);
  }
  for (const auto& [name, value] : surroundings.environment) prepared.environment.push_back(name + "=" + value);
  prepared.word_pointers = Prepared::Pointers(prepared.words);
  prepared.environment_pointers = Prepared::Pointers(prepared.environment);
  return prepared;
}

void Redirect(int descriptor, const std::string& file) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
  dup2(opened, descriptor);
  close(opened);
}

void BreakPipe(int descriptor) {
  int ends[2] = {};
  if (pipe(ends) != 0) _exit(127);
  close(ends[0]);
  dup2(ends[1], descriptor);
  close(ends[1]);
}

[[noreturn]] void Become(const Prepared& prepared, const Surroundings& surroundings, const std::string& output,
                         const std::string& error) {
  if (!surroundings.standard_input.empty()) dup2(open(surroundings.standard_input.c_str(), O_RDONLY), STDIN_FILENO);
  Redirect(STDOUT_FILENO, output);
  Redirect(STDERR_FILENO, error);
  if (surroundings.break_output) BreakPipe(STDOUT_FILENO);
  if (surroundings.close_output) close(STDOUT_FILENO);
  if (surroundings.close_error) close(STDERR_FILENO);
  // Background jobs of a script and programs started by nohup inherit ignored signals.
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) signal(number, SIG_DFL);
  if (surroundings.file_size_limit >= 0) {
    const auto limit = static_cast<rlim_t>(surroundings.file_size_limit);
    const rlimit both = {limit, limit};
    setrlimit(RLIMIT_FSIZE, &both);
  }
  if (surroundings.deny_threads) {
    constexpr unsigned nobody = 65534;
    const rlimit one = {1, 1};
    setrlimit(RLIMIT_NPROC, &one);
    if (geteuid() == 0 && (setgid(nobody) != 0 || setuid(nobody) != 0)) _exit(127);
  }
  execve(prepared.word_pointers[0], prepared.word_pointers.data(), prepared.environment_pointers.data());
  _exit(127);
}

/// Whether the process has a handler for the signal; true on systems that do not report it as Linux does.
bool Catches(pid_t process, int signal) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  const std::string caught = "SigCgt:";
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(caught)) return std::stoull(line.substr(caught.size()), nullptr, 16) >> (signal - 1) & 1;
  return true;
}

}  // namespace

std::vector<std::string> TemporaryFolder::Others(const std::vector<std::string>& known) const {
  std::vector<std::string> others;
  for (const auto& entry : fs::directory_iterator(Path())) {
    const std::string name = entry.path().filename().string();
    if (std::ranges::find(known, name) == known.end()) others.push_back(name);
  }
  return others;
}

std::string WriteFile(const std::string& file, const std::string& content) {
  std::ofstream(file, std::ios::binary) << content;
  return file;
}

R2::DecodedImage Decode(const std::string& file) {
  const std::string bytes = ReadFile(file);
  return R2::DecodeImage({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
}

std::vector<std::string> With(std::vector<std::string> words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Running::Running(const std::vector<std::string>& words, const Surroundings& surroundings) {
  const Prepared prepared = Prepare(words, surroundings);
  const std::string output =
      surroundings.standard_output.empty() ? collected_ / "output" : surroundings.standard_output;
  const std::string error = surroundings.standard_error.empty() ? collected_ / "error" : surroundings.standard_error;
  process_ = fork();
  if (process_ == 0) Become(prepared, surroundings, output, error);
}

Running::~Running() {
  if (IsOver()) return;
  Send(SIGKILL);
  waitpid(process_, &wait_status_, 0);
}

void Running::Send(int signal) {
  if (!IsOver()) kill(process_, signal);
}

void Running::WaitUntilItCatches(int signal) {
  using namespace std::chrono_literals;
  const auto end = std::chrono::steady_clock::now() + 1min * project::patience;
  while (!IsOver() && !Catches(process_, signal) && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(1ms);
}

bool Running::IsOver() {
  if (!is_over_) is_over_ = waitpid(process_, &wait_status_, WNOHANG) == process_;
  return is_over_;
}

Finished Running::Wait(std::chrono::milliseconds longest) {
  using namespace std::chrono_literals;
  const auto end = std::chrono::steady_clock::now() + longest * project::patience;
  while (!IsOver() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(500us);
  if (!IsOver()) {
    Send(SIGKILL);
    waitpid(process_, &wait_status_, 0);
    is_over_ = true;
  }
  return {.status = WIFEXITED(wait_status_) ? WEXITSTATUS(wait_status_) : -1,
          .signal = WIFSIGNALED(wait_status_) ? WTERMSIG(wait_status_) : 0,
          .output = ReadFile(collected_ / "output"),
          .error = ReadFile(collected_ / "error")};
}

const char* ProgramName(const char* variable) { return std::getenv(variable); }

Finished RunProgram(const std::vector<std::string>& words, const Surroundings& surroundings) {
  return Running(words, surroundings).Wait();
}

int Rounds(const char* variable, int unless_set) {
  const char* text = std::getenv(variable);
  return text ? std::max(1, std::atoi(text)) : unless_set;
}

}  // namespace ray::testing
