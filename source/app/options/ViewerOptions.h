#pragma once

#include <array>
#include <string>

#include "source/app/options/RenderOptions.h"

namespace ray {

/// What only rayview is asked. Names of files are as typed; empty for none.
struct ViewOptions {
  std::string output_image;  // gets what the window shows when the program ends
  bool exit_immediately = false;
  bool headless = false;
  std::string context = "auto";  // what headless draws with, one of context_names
  std::string events;            // a script; "-" is standard input
  std::string screenshot;        // gets the drawing after the last event
  std::string record;            // gets what happens, as a script
  std::string reference;         // picture to compare with
  std::string rays;              // file of rays of another tracer
  std::string panels = "off";    // from the start, one of panel_themes
  std::string preview = "auto";  // what the window shows at rest, one of preview_names
};
inline constexpr std::array preview_names{"auto", "traced", "gl"};
inline constexpr std::array panel_themes{"off", "dark", "light"};
inline constexpr std::array context_names{"auto", "egl", "osmesa"};

/// What rayview is asked: what raypro is, and its window.
struct ViewerOptions : RenderOptions {
  ViewerOptions() : RenderOptions(Program::rayview) { render.width = render.height = 512; }  // the course's window

  ViewOptions view;
};

}  // namespace ray
