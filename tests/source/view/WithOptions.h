#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "tests/source/view/Witness.h"

namespace ray {

/// A program with two options.
class WithOptions : public Witness {
 public:
  std::vector<ShownOption> ShownOptions() override {
    return {{"mode", "light", "what is rendered", mode, "one of two", {"whitted", "path"}, false},
            {"samples", "light", "per pixel", std::to_string(samples), "1 to 9", {}, false}};
  }
  ViewerSettings ChangeOption(const std::string& name, const std::string& value) override {
    if (name == "mode") mode = value;
    if (name == "accel") accelerator = value;
    if (name == "samples" && (value.size() != 1 || value[0] < '1'))
      throw std::runtime_error("-samples must be 1 to 9, got " + value);
    if (name == "samples") samples = value[0] - '0';
    ViewerSettings settings;
    settings.render.mode = mode == "path" ? RenderMode::path : RenderMode::whitted;
    settings.render.samples = samples;
    settings.accelerator.name = accelerator;
    return settings;
  }
  std::string CommandFor(const RenderSettings& settings) override {
    return "make -samples " + std::to_string(settings.samples);
  }

  std::string mode = "whitted", accelerator = "auto";
  int samples = 1;
};

}  // namespace ray
