#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>

/// Displays for tests of windows.
namespace ray::testing {

/// Sets a variable of the environment, or takes it away, until it ends.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    Set(value);
  }
  ~Variable() { Set(old_ ? old_->c_str() : nullptr); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  void Set(const char* value) { value ? setenv(name_, value, 1) : unsetenv(name_); }

  const char* name_;
  std::optional<std::string> old_;
};

/// Whether there are what a Server and its user need.
inline bool HasServerAndUser() {
  return std::system("command -v Xvfb >/dev/null && command -v xdotool >/dev/null") == 0;
}

/// An X server without a screen; the display is empty when it does not start.
class Server {
 public:
  Server() {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return;
    process_ = fork();
    if (process_ == 0) {
      const std::string end = std::to_string(ends[1]);
      close(ends[0]);
      if (!std::freopen("/dev/null", "w", stderr)) _exit(127);
      // Without a reset, during which it takes nobody, after the last program that uses it.
      execlp("Xvfb", "Xvfb", "-displayfd", end.c_str(), "-screen", "0", "800x600x24", "-nolisten", "tcp", "-noreset",
             nullptr);
      _exit(127);
    }
    close(ends[1]);
    // The number and the end of its line may come apart.
    std::string number;
    for (char c = 0; process_ > 0 && c != '\n' && read(ends[0], &c, 1) == 1;) number += c;
    if (number.size() > 1) display_ = ":" + number.substr(0, number.size() - 1);
    close(ends[0]);
  }
  ~Server() {
    if (process_ <= 0) return;
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  const std::string& Display() const { return display_; }

 private:
  pid_t process_ = -1;
  std::string display_;
};

}  // namespace ray::testing
