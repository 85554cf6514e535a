#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "source/app/options/Options.h"

namespace ray::raygrade {

/// The protection from students' programs.
enum class SandboxMode { automatic, bubblewrap, limits };
inline constexpr std::array sandbox_names{"auto", "bubblewrap", "limits"};
constexpr const auto& NamesOf(SandboxMode) { return sandbox_names; }

/// The options of raygrade; its names are the suite, then the words of a student's command. Ranges and help are in
/// Table.cpp; the defaults are here.
struct GradeOptions : Options {
  GradeOptions() : Options(Program::raygrade) {}

  std::string out = "graded";      // folder for pages and tables
  std::string results;             // file for Gradescope; empty: results.json in `out`
  std::string students;            // folder with one folder per student; empty: one student
  std::string build;               // a shell command that builds a student's program; empty: the suite's
  std::string image = "png";       // extension of {image}
  std::uint64_t seed = 0;
  SandboxMode sandbox = SandboxMode::automatic;
  bool resume = false;
  bool matrix = false;    // try every known mistake instead of grading
  int pairs = 0;          // number of pairs of mistakes that the matrix also tries
  std::string new_suite;  // folder of scenes for a new suite
};

}  // namespace ray::raygrade
