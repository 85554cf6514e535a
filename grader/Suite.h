#pragma once

#include <string>
#include <vector>

#include "source/parse/SceneError.h"

namespace ray::grade {

/// A text of a scene file and its replacement with a seed: {a..b} is a number between a and b.
struct Variation {
  std::string text, becomes;
  SceneError at{};  // its place in the suite
};

/// A scene that a student's program has to render.
struct SuiteScene {
  std::string name;            // of its file, without folder and extension; unique
  std::string file;            // relative to the current folder
  std::string title, teaches;  // for people; may be empty
  double points = 1;           // >= 0
  int width = 160, height = 120;
  double seconds = 10;      // limit of the program
  double tolerance = 0.02;  // of a displayed channel, 0 to 1
  double allowed = 0.5;     // percentage of steady pixels that may differ by more
  // of the program: above 1 if it samples at random; then means of blocks are compared
  int runs = 1;
  std::string options;      // of raypro, for the reference
  SceneError options_at{};  // their place in the suite
  std::vector<Variation> vary{};
};

/// The basis of grading: a YAML file.
struct Suite {
  std::string file, name;
  std::vector<std::string> command;   // the default; may be empty
  std::string build;                  // the default shell command that builds a program; empty for none
  double build_seconds = 120, build_memory = 4096;  // limits of the build
  double memory = 768;                // limit of the program in MiB
  double budget = 0;                  // seconds for all scenes together; 0: no limit
  // share of a scene's points if known mistakes explain everything that is wrong
  double explained = 0.5;
  std::vector<std::string> readable;  // more files and folders that programs may read
  std::vector<SuiteScene> scenes;
  std::vector<std::string> warnings;  // about parts of the file without an effect, with their places

  double Points() const;
};

/// Reads a suite. Throws SceneErrors with the places of all mistakes.
Suite ReadSuite(const std::string& file);

/// Returns a suite of every scene in a folder, as text. Throws SceneErrors if there is none.
std::string NewSuite(const std::string& folder);

}  // namespace ray::grade
