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
  bool shows_traced = false;     // from the start: what the view shows at rest is traced
  bool budget_of_rest = false;   // no budget was requested, see TracedImages::Update
  bool shows_bar = false;        // the status bar, even without panels
  PanelSettings panels{};        // how they look when they are first shown
};

/// An option of the program, as a panel shows it.
struct ShownOption {
  std::string name, topic, help;     // without the dash
  std::string value;                 // in force, as it would be typed; empty for none
  std::string range;                 // a description of what may be typed
  std::vector<std::string> choices;  // where these are all; empty otherwise
  bool is_flag = false;              // given or not: the value is "on" or empty
};

/// The program around a viewer. The strings returned are messages for the user.
class ViewerHost {
 public:
  virtual ~ViewerHost() = default;
  /// Writes the image of key S.
  virtual std::string SaveTraced(const RenderJob& complete) = 0;
  /// Keeps the image of key S, which was stopped, so that a program without a viewer can continue it. Returns how, or
  /// why not; empty if that was not requested.
  virtual std::string KeepStopped(const RenderJob&) { return {}; }
  /// Writes what is drawn, once the event that requested it is handled.
  virtual void SaveDrawing() = 0;
  /// Writes rays as an .obj file.
  virtual std::string SaveRays(const std::string& obj) = 0;
  /// Writes a file whole or not at all. Returns why it could not, else nothing.
  virtual std::string SaveText(const std::string& file, const std::string& text) = 0;
  /// Does the same for the scene that is shown, which no other output may replace.
  virtual std::string SaveScene(const std::string& file, const std::string& text) { return SaveText(file, text); }
  /// Scenes that were opened before, the last first.
  virtual std::vector<std::string> RecentScenes() { return {}; }
  /// Reads an image; the result is empty if the file cannot be read as one. Called in any thread.
  virtual ReferenceImage ReadImage(const std::string& file) = 0;
  /// A file was read, which no output may replace from now on.
  virtual void NoteRead(const std::string&) {}
  virtual void SetClipboard(const std::string& text) = 0;
  /// Prints a line to standard output.
  virtual void Print(const std::string& line) = 0;

  // A program without options has none to show.
  /// The options that bear on images, topic by topic.
  virtual std::vector<ShownOption> ShownOptions() { return {}; }
  /// Returns the settings once the option has the value, empty for its default; without a reference. Throws an
  /// exception whose what() is for the user where that cannot be.
  virtual ViewerSettings ChangeOption(const std::string& name, const std::string&) {
    throw std::invalid_argument("there is no option " + name);
  }
  /// Returns the settings once this scene is shown, which may have settings of its own; std::nullopt to keep them as
  /// before. Throws as ChangeOption.
  virtual std::optional<ViewerSettings> SettingsWith(const Scene&) { return {}; }
  /// The command that makes such an image without a viewer; empty where there is none.
  virtual std::string CommandFor(const RenderSettings&) { return {}; }
};

}  // namespace ray
