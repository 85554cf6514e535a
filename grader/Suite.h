#pragma once

#include <string>
#include <utility>
#include <vector>

#include "source/parse/SceneError.h"

namespace ray::grade {

/// A text of a scene file and what it becomes with a seed: {a..b} is a number between a and b.
struct Variation {
  std::string text, becomes;
  SceneError at{};  // where it stands in the suite
};

/// A scene that a student's program has to render.
struct SuiteScene {
  std::string name;            // of its file, without folder and extension; no two are alike
  std::string file;            // relative to the current folder
  std::string title, teaches;  // for people; may be empty
  double points = 1;           // >= 0
  int width = 160, height = 120;
  double seconds = 10;      // that the program may take
  double tolerance = 0.02;  // of a displayed channel, 0 to 1
  double allowed = 0.5;     // percent of the steady pixels that may differ by more
  int runs = 1;             // of the program: above 1 where it samples at random, and then means of blocks are compared
  std::string options;      // of raypro, for the reference
  SceneError options_at{};  // where they stand
  std::vector<Variation> vary{};
};

/// What to grade by: a YAML file.
struct Suite {
  std::string file, name;
  std::vector<std::string> command;   // the usual one; may be empty
  std::string build;                  // the usual line for the shell that builds a program; empty for none
  double build_seconds = 120, build_memory = 4096;  // limits of that
  double memory = 768;                // MiB that the program may take
  double budget = 0;                  // seconds for all scenes together; 0: no limit
  double explained = 0.5;             // share of a scene's points where known mistakes explain all that is wrong
  std::vector<std::string> readable;  // more files and folders that programs may read
  std::vector<SuiteScene> scenes;
  std::vector<std::string> warnings;  // of what is in the file and has no effect, with its place

  double Points() const;
};

/// Throws SceneErrors with the places of all mistakes.
Suite ReadSuite(const std::string& file);

/// A suite of every scene in a folder, as text. Throws SceneErrors where there is none.
std::string NewSuite(const std::string& folder);

}  // namespace ray::grade
