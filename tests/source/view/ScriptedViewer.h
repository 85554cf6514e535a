#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <thread>

#include "source/scene/CameraText.h"
#include "source/view/EventScript.h"
#include "tests/Project.h"
#include "tests/source/view/CopiedScenes.h"
#include "tests/source/view/Witness.h"

namespace ray {

/// A viewer whose user is a script.
template <class Host, int width_of_drawing, int height_of_drawing>
class ScriptedViewer : public ::testing::Test {
 protected:
  static constexpr int width = width_of_drawing, height = height_of_drawing;  // when it is opened

  void Open(const std::filesystem::path& scene, const RenderSettings& render = {}, bool budget_of_rest = false) {
    ViewerSettings settings;
    settings.scene = scene;
    settings.render = render;
    settings.render.width = width;
    settings.render.height = height;
    settings.budget_of_rest = budget_of_rest;
    settings.shows_bar = shows_bar_;
    viewer_ = std::make_unique<Viewer>(
        settings, std::make_shared<const LoadedScene>(scene, settings.parse, settings.accelerator), host_);
    viewer_->WaitForFaces();
  }
  void SetUp() override { Open(project::Root() / "scenes/hello.scn"); }

  /// Steps of a script, but for images and prints.
  void Do(const std::string& script) {
    for (const ScriptStep& step : ReadEventScript({"test", script})) {
      if (const auto* event = std::get_if<Event>(&step.what)) viewer_->Handle(*event);
      viewer_->WaitForScene();
      viewer_->Update();
      if (std::holds_alternative<WaitForTrace>(step.what)) WaitUntilIdle();
    }
  }
  void WaitUntilIdle() {
    while (viewer_->IsBusy()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      viewer_->Update();
    }
    viewer_->Update();
  }

  bool shows_bar_ = false;  // of viewers opened from now on
  Host host_;
  std::unique_ptr<Viewer> viewer_;
};

/// One of few pixels, without panels.
class ViewerTest : public ScriptedViewer<Witness, 64, 48> {
 protected:
  const Camera& camera() const { return viewer_->navigator().camera(); }
  bool IsCameraOf(const Camera& c) const { return CameraLine(camera()) == CameraLine(c); }
  R2::Image Rendered(const RenderSettings& settings) const {
    const LoadedScene& scene = viewer_->scene();
    return Render(scene.world, *scene.accelerator, settings).image;
  }
  std::string StateLine(const std::string& name) const {
    std::istringstream in(viewer_->Describe());
    for (std::string line; std::getline(in, line);)
      if (line.compare(0, name.size() + 1, name + " ") == 0) return line.substr(name.size() + 1);
    return "no such line";
  }
};

}  // namespace ray
