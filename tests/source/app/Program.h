#pragma once

#include <sys/types.h>

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include "R2/ImageFile.h"
#include "tests/Folder.h"
#include "tests/Sanitizers.h"

/// Runs the real programs, which the environment variables RAYPRO, RAYIMG and RAYVIEW name, and examines the files that
/// they leave behind.
namespace ray::testing {

/// A folder whose files have names for command lines.
class TemporaryFolder : public project::Folder {
 public:
  std::string operator/(const std::string& name) const { return (Path() / name).string(); }
  /// Returns the names of all files in it that are not in `known`.
  std::vector<std::string> Others(const std::vector<std::string>& known) const;
};

inline bool Has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::string ReadFile(const std::string& file) { return project::BytesOf(file); }
/// Writes a file and returns its name.
std::string WriteFile(const std::string& file, const std::string& content);
R2::DecodedImage Decode(const std::string& file);

inline const std::vector<std::string> nothing;
/// Returns the words of a command line followed by more words.
std::vector<std::string> With(std::vector<std::string> words, const std::vector<std::string>& more);

inline const std::string small_scene = "camera 0 0 6  0 0 -1  0 1 0  0.3  0.1 100\nsphere -1  0 0 0  1\n";

/// A folder with a scene in it.
struct SceneFolder : TemporaryFolder {
  explicit SceneFolder(const std::string& text = small_scene) { WriteFile(Scene(), text); }
  std::string Scene() const { return *this / "in.scn"; }
};

/// The environment of a program besides its arguments.
struct Surroundings {
  const char* program = "RAYPRO";                  // the variable that names the program
  std::string standard_output{};                   // a file; empty: collected
  std::string standard_error{};                    // likewise
  std::string standard_input{};                    // a file; empty: inherited from the test
  bool close_output = false, close_error = false;  // descriptors not open at all
  bool break_output = false;                       // a pipe without a reader
  long file_size_limit = -1;                       // bytes; -1 for none
  bool deny_threads = false;                       // for the superuser, the program is run as nobody
  std::map<std::string, std::string> environment{};
};

struct Finished {
  int status = -1;  // exit status; -1 when a signal ended it
  int signal = 0;
  std::string output, error;
};

/// A program that runs beside the test.
class Running {
 public:
  Running(const std::vector<std::string>& words, const Surroundings& surroundings = {});
  ~Running();  // kills it unless it was waited for
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// No value after it has ended: by then its number may belong to another process.
  void Send(int signal);
  /// Waits until the program has a handler for the signal, which may take seconds on a busy machine, or until it ends.
  void WaitUntilItCatches(int signal);
  /// Kills it after this time (ten times as long under a sanitizer): `status` is then -1.
  Finished Wait(std::chrono::milliseconds longest = std::chrono::minutes(2));
  bool IsOver();

 private:
  TemporaryFolder collected_;
  pid_t process_ = -1;
  bool is_over_ = false;
  int wait_status_ = 0;
};

/// Null unless the environment names the program.
const char* ProgramName(const char* variable = "RAYPRO");
Finished RunProgram(const std::vector<std::string>& words, const Surroundings& surroundings = {});

/// Returns a number of repetitions, from the environment if it is set there.
int Rounds(const char* variable, int unless_set);

}  // namespace ray::testing

/// The first line of every test that runs a program.
#define NEEDS_THE_PROGRAM() \
  if (!ray::testing::ProgramName()) GTEST_SKIP() << "the environment variable RAYPRO does not name the program"
#define NEEDS_RAYIMG() \
  if (!ray::testing::ProgramName("RAYIMG")) GTEST_SKIP() << "the environment variable RAYIMG does not name rayimg"
#define NEEDS_RAYVIEW() \
  if (!ray::testing::ProgramName("RAYVIEW")) GTEST_SKIP() << "the environment variable RAYVIEW does not name rayview"
