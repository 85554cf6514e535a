#pragma once

#include <array>
#include <string>

#include "source/app/options/RenderOptions.h"

namespace ray {

/// The options that only rayview has. File names are as typed; empty for none.
struct ViewOptions {
  std::string output_image;  // receives the window's content when the program exits
  bool exit_immediately = false;
  bool headless = false;
  std::string context = "auto";  // the context for headless drawing, one of context_names
  std::string events;            // a script; "-" is standard input
  std::string screenshot;        // receives the drawing after the last event
  std::string record;            // receives the events as a script
  std::string reference;         // image to compare with
  std::string rays;              // file of rays of another tracer
  std::string panels = "off";    // initial panels, one of panel_themes
  std::string preview = "auto";  // what a view at rest shows, one of preview_names
};
inline constexpr std::array preview_names{"auto", "traced", "gl"};
inline constexpr std::array panel_themes{"off", "dark", "light"};
inline constexpr std::array context_names{"auto", "egl", "osmesa"};

/// The options of rayview: those of raypro, and its window.
struct ViewerOptions : RenderOptions {
  ViewerOptions() : RenderOptions(Program::rayview) {
    render.width = render.height = default_image.side = 512;  // the course's window
  }

  ViewOptions view;
};

}  // namespace ray
