#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/parse/Parse.h"
#include "source/render/RenderSettings.h"
#include "source/view/compare/ReferenceImage.h"
#include "source/view/live/RenderJob.h"
#include "source/view/panels/Panels.h"

namespace ray {

/// The initial settings of a viewer.
struct ViewerSettings {
  std::string scene;  // its file
  ParseOptions parse;
  AcceleratorSettings accelerator;
  RenderSettings render;  // of traced images; their size is that of the drawing
  ReferenceImage reference;
  bool shows_traced = false;    // from the start: a view at rest is traced
  bool budget_of_rest = false;  // no budget was requested, see TracedImages::Update
  bool shows_bar = false;       // the status bar, even without panels
  PanelSettings panels{};       // their initial look
};

/// An option of the program, as a panel shows it.
struct ShownOption {
  std::string name, topic, help;     // without the dash
  std::string value;                 // the current one, as it would be typed; empty for none
  std::string range;                 // a description of valid values
  std::vector<std::string> choices;  // all valid values, if they can be listed
  bool is_flag = false;              // given or not: the value is "on" or empty
};

/// The program around a viewer. The strings returned are messages for the user.
class ViewerHost {
 public:
  virtual ~ViewerHost() = default;
  /// Writes the image of key S.
  virtual std::string SaveTraced(const RenderJob& complete) = 0;
  /// Keeps the stopped image of key S, so that a program without a viewer can continue it. Returns a message that says
  /// how, or why not; empty if that was not requested.
  virtual std::string KeepStopped(const RenderJob&) { return {}; }
  /// Saves the drawing, after the event that requested it.
  virtual void SaveDrawing() = 0;
  /// Writes rays as an .obj file.
  virtual std::string SaveRays(const std::string& obj) = 0;
  /// Writes a file completely or not at all. Returns the reason if it could not; empty otherwise.
  virtual std::string SaveText(const std::string& file, const std::string& text) = 0;
  /// Does the same for the current scene, which no other output may replace.
  virtual std::string SaveScene(const std::string& file, const std::string& text) { return SaveText(file, text); }
  /// Scenes that were opened before, the last first.
  virtual std::vector<std::string> RecentScenes() { return {}; }
  /// Reads an image; the result is empty if the file cannot be read as one. Called in any thread.
  virtual ReferenceImage ReadImage(const std::string& file) = 0;
  /// Registers an input file, which no later output may replace.
  virtual void NoteRead(const std::string&) {}
  virtual void SetClipboard(const std::string& text) = 0;
  /// Prints a line to standard output.
  virtual void Print(const std::string& line) = 0;

  // The program's options, if it has any.
  /// The options that affect images, by topic.
  virtual std::vector<ShownOption> ShownOptions() { return {}; }
  /// Returns the settings with a new value of the option, empty for its default; without a reference. Throws an
  /// exception whose what() is for the user if the value is refused.
  virtual ViewerSettings ChangeOption(const std::string& name, const std::string&) {
    throw std::invalid_argument("there is no option " + name);
  }
  /// Returns the settings for this scene, which may contain settings; std::nullopt to keep the current ones.
  /// Throws as ChangeOption.
  virtual std::optional<ViewerSettings> SettingsWith(const Scene&) { return {}; }
  /// The command that makes such an image without a viewer; empty if there is none.
  virtual std::string CommandFor(const RenderSettings&) { return {}; }
};

}  // namespace ray
