#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "source/view/Event.h"
#include "source/view/FileWatch.h"
#include "source/view/FrameState.h"
#include "source/view/HelpText.h"
#include "source/view/camera/Bookmarks.h"
#include "source/view/camera/Navigator.h"
#include "source/view/compare/ImageStrip.h"
#include "source/view/edit/SceneEditor.h"
#include "source/view/live/AcceleratorCost.h"
#include "source/view/live/TracedPictures.h"
#include "source/view/overlay/Pick.h"
#include "source/view/overlay/RayInspector.h"
#include "source/view/overlay/SectionView.h"
#include "source/view/panels/Panels.h"

namespace ray {

/// What a viewer begins with.
struct ViewerSettings {
  std::string scene;  // its file
  ParseOptions parse;
  AcceleratorSettings accelerator;
  RenderSettings render;  // of traced pictures; their size is that of the drawing
  ReferenceImage reference;
  bool live_is_endless = false;  // live rendering without a budget goes on until it is stopped
  PanelSettings panels{};        // how they look when they are first shown
};

/// An option of the program, as a panel shows it.
struct ShownOption {
  std::string name, topic, help;     // without the dash
  std::string value;                 // in force, as it would be typed; empty for none
  std::string range;                 // what may be typed, in words
  std::vector<std::string> choices;  // where these are all; empty otherwise
  bool is_flag = false;              // given or not: the value is "on" or empty
};

/// What a viewer asks of the program around it. The strings returned are messages for the user.
class ViewerHost {
 public:
  virtual ~ViewerHost() = default;
  /// Writes the picture of key S.
  virtual std::string SaveTraced(const RenderJob& complete) = 0;
  /// Writes what is drawn, once the event that asked for it is handled.
  virtual void SaveDrawing() = 0;
  /// Writes rays as an .obj file.
  virtual std::string SaveRays(const std::string& obj) = 0;
  /// Writes a file whole or not at all. Returns why it could not, else nothing.
  virtual std::string SaveText(const std::string& file, const std::string& text) = 0;
  /// Likewise, of the scene that is shown, which other files never take the place of.
  virtual std::string SaveScene(const std::string& file, const std::string& text) { return SaveText(file, text); }
  /// Scenes that were opened before, the last first.
  virtual std::vector<std::string> RecentScenes() { return {}; }
  /// Without an image where the file is none that can be read.
  virtual ReferenceImage ReadPicture(const std::string& file) = 0;
  virtual void SetClipboard(const std::string& text) = 0;
  /// To standard output.
  virtual void Print(const std::string& line) = 0;

  // A program without options has none to show.
  /// Those that bear on pictures, topic by topic.
  virtual std::vector<ShownOption> ShownOptions() { return {}; }
  /// What the viewer goes on with once the option has the value, empty for its default; without a reference. Throws an
  /// exception whose what() is for the user where that cannot be.
  virtual ViewerSettings ChangeOption(const std::string& name, const std::string& value);
  /// What the viewer goes on with once it shows this scene, which may have settings of its own; nothing to go on as
  /// before. Throws as ChangeOption.
  virtual std::optional<ViewerSettings> SettingsWith(const Scene&) { return {}; }
  /// The command that makes such a picture without a viewer; empty where there is none.
  virtual std::string CommandFor(const RenderSettings&) { return {}; }
};

/// A scene being looked at: what the user's events do to it, and what is to be drawn. Knows nothing of windows and
/// OpenGL; for one thread.
class Viewer {
 public:
  /// `scene`: read from the settings' file. The host must outlive it.
  Viewer(ViewerSettings settings, std::shared_ptr<const LoadedScene> scene, ViewerHost& host);

  void Handle(const Event& event);
  /// Starts and ends what is due. Returns whether Show would return something else than the last time.
  bool Update();
  /// Valid until the next call of Handle or Update.
  FrameState Show();
  /// Whether a picture is being traced, so that Update is soon worth a call.
  bool IsBusy() const { return pictures_.IsBusy() || (accelerators_ && !accelerators_->HasEnded()); }
  bool IsClosed() const { return is_closed_; }
  /// "hello.scn 512x512 4 of 16 samples 31 % 0.5 Mrays/s 12 s left": as of the last Update, and changed by time alone
  /// a few times a second.
  std::string Title() const;
  /// How far the image that is rendered has come: "4 of 16 samples 31 % 0.5 Mrays/s 12 s left"; empty without any.
  const std::string& Status() const { return status_; }
  /// What it shows, in lines of words, for scripts.
  std::string State();

  /// A key and what it does. All keys are in one table, of which the help is made.
  struct Binding {
    Key key;
    Modifiers modifiers;
    const char* help;  // empty: as the line before
    std::function<void(Viewer&)> act;
    std::function<void(Viewer&)> release = nullptr;  // where it lasts as long as the key is held
  };
  static const std::vector<Binding>& Bindings();
  /// Gestures and keys in groups, a line each.
  static std::vector<std::string> Help();
  static std::vector<HelpRow> HelpRows();

  const LoadedScene& scene() const { return *scene_; }
  const Navigator& navigator() const { return navigator_; }
  const TracedPictures& Pictures() const { return pictures_; }
  const RayInspector& Rays() const { return rays_; }
  const SectionView& Section() const { return section_; }
  const std::optional<Pick>& Picked() const { return pick_; }
  const std::string& Message() const { return message_; }
  DrawingSize Size() const { return size_; }
  /// Another for each scene that was opened or read again, from 1.
  int SceneNumber() const { return scene_number_; }
  bool ShowsPanels() const { return shows_panels_; }
  /// What the panels and the help say, in lines; none where they are hidden.
  std::string TextOfPanels() { return shows_panels_ || shows_help_ ? panels_->Text(*this) : std::string(); }
  /// What takes clicks in the panels, as last drawn.
  const std::vector<PanelItem>& ItemsOfPanels() const;

  void ShowPanels(const PanelSettings& look);
  /// How they look, or will when they are shown.
  const PanelSettings& PanelLook() const { return panels_->Look(); }

  /// The file of the settings has these mistakes, and the scene shown is another.
  void TellMistakes(const SceneErrors& mistakes) { TellProblems(settings_.scene, mistakes); }
  /// Shows a message, of what the program around the viewer did for it.
  void Tell(const std::string& message) { ShowMessage(message); }

  // Editing, and other scenes: ViewerEdits.cpp.
  const SceneEditor& Editor() const { return editor_; }
  SceneEditor& Editor() { return editor_; }
  /// Reads the scene with these texts in place of its files; camera, options and pictures stay. Returns why it could
  /// not, and then shows what it did before; else nothing.
  std::string ShowEdits(std::shared_ptr<const EditedFiles> texts);
  /// Returns why it could not be written, else nothing.
  std::string SaveScene(const std::string& file, const std::string& text);
  /// Unless that would lose edits; then a message says so, and it is opened when it is asked for again.
  void OpenScene(const std::string& file) { Open(file); }
  /// Whether the scenes that can be opened are listed.
  bool ListsScenes() const { return lists_scenes_; }
  std::vector<std::string> RecentScenes() const { return host_.RecentScenes(); }
  const std::string& SceneFile() const { return settings_.scene; }

  // Images, compared: ViewerEdits.cpp.
  double ExposureSteps() const { return exposure_steps_; }
  /// In stops: each doubles the light.
  void SetExposure(double steps);
  const ImageStrip& Images() const { return images_; }
  /// One of these in place of the current image; nothing for the current one. It is the reference as well.
  void ShowImage(std::optional<std::size_t> index);
  std::optional<std::size_t> ShownImage() const;

  // What panels ask for.
  void SetPanelLook(const PanelSettings& look);
  /// A node of the scene graph to look at, into World::Nodes; nothing for none. A picked one is chosen as well.
  void ChooseNode(std::optional<std::size_t> node);
  std::optional<std::size_t> ChosenNode() const { return chosen_node_; }
  void FrameChosenNode();
  /// One of the rays of Rays().Pixel(), by its number, to be lit up; nothing for none.
  void ChooseRay(std::optional<std::size_t> ray);
  /// Empty for the option's default. While the picture of key S is being rendered options stay as they are.
  void ChangeOption(const std::string& name, const std::string& value);
  /// Why the last change of an option was refused; empty when it was not.
  const std::string& OptionProblem() const { return option_problem_; }
  std::vector<ShownOption> ShownOptions() const { return host_.ShownOptions(); }
  /// Of those that are drawn in space.
  void ToggleRays(ShownRays kind);
  void ToggleNormals();
  /// How many rays are traced to be looked at from now on, and which.
  void SetDebugRays(const DebugRayCounts& counts);
  /// The command that renders what is seen; but for the camera, where that was moved.
  std::string Command() const { return host_.CommandFor(SettingsOfView()); }
  bool HasMovedCamera() const { return SettingsOfView().view.has_value(); }
  /// Live rendering of one mode; nothing for none.
  void ShowLayer(std::optional<RenderMode> mode);
  /// Where the pointer was last seen, in pixels of the picture; outside of it before that.
  R2::Point Pointer() const { return InPicture(pointer_); }
  /// Begins to find what accelerators cost in the present view, in the background.
  void CompareAccelerators();
  void StopComparingAccelerators();
  /// What was begun last; null before that, and for another scene.
  const AcceleratorComparison* ComparedAccelerators() const { return accelerators_.get(); }
  /// What is wrong with the scene's files as they are now, while an earlier scene stays; empty where nothing is.
  const std::vector<SceneError>& SceneProblems() const { return scene_problems_; }
  /// Into the clipboard.
  void CopyText(const std::string& text) { host_.SetClipboard(text); }

  /// The settings to render the present view with.
  RenderSettings SettingsOfView() const;

 private:
  enum class Boxes { none, nodes, accelerator };
  struct Press {
    Button button;
    R2::Point at;
    bool is_click = true;       // until it has gone too far
    bool on_section = false;    // it measures the cross section
    bool moves_flat = false;    // it moves the flat picture,
    bool moves_slider = false;  // or its slider
    bool moves_chosen = false;  // or what is chosen in the scene
  };

  void On(const KeyEvent& event);
  void On(const TextEvent&) {}
  void On(const ButtonEvent& event);
  void On(const MoveEvent& event);
  void On(const ScrollEvent& event);
  void On(const ResizeEvent& event);
  void On(const DropEvent& event);
  void On(const TickEvent& event);
  void On(const CloseEvent&) { Quit(); }
  void OnClick(const ButtonEvent& event);
  void PickAt(const R2::Point& position);

  struct BindingTable;
  /// What a picture of key S depends on.
  struct TracedAs {
    int scene = 0, options = 0;  // numbers
    std::string camera;          // as a line
    DrawingSize size;
    friend bool operator==(const TracedAs&, const TracedAs&) = default;
  };
  /// The ray through a position in the drawing.
  R3::Ray RayAt(const R2::Point& position) const;
  void FocusUnderPointer();
  /// A finished image goes to the strip of them.
  void KeepImage(const RenderJob& job);
  void FlipImages(int by);
  void ToggleDenoising();
  void ToggleSceneList();
  /// To the scene so many files behind this one in its folder, or before it.
  void OpenNeighbor(int by);
  /// What the disk has, in place of edits.
  void ReadFromDisk();
  void TellOfChangedFiles();
  void StartTrace();
  /// Ends the uppermost of what is open: the help, the pick, the cross section, the trace.
  void Peel();
  void Quit();
  void ToggleLights();
  void PrintCamera();
  void CycleBoxes();
  void ChangeBoxLevel(int by);
  void FrameScene();
  void FramePicked();
  /// The angle that is seen from side to side.
  std::string AngleInWords() const;
  void KeepBookmark(int digit);
  void RecallBookmark(int digit);
  void ToggleGrid();
  void MoveByArrow(int right, int up);
  void ToggleFlat();
  /// What is shown flat; null where nothing is.
  const RenderJob* FlatJob() const;
  /// Of what is seen: the flat picture, or the view.
  RenderSettings SettingsOfPicture() const;
  Camera CameraOfPicture() const;
  /// Of the rectangle that the preview is drawn in: the view, or the flat picture beside its slider.
  DrawingSize SizeOfPreview() const;
  void DragFlat(const R2::Point& from, const R2::Point& to);
  bool TakesSlider(const ButtonEvent& event) const;
  void ZoomFlat(const ScrollEvent& event);
  void ShowFlat(FrameState& shown) const;
  /// The sides of its slider, and what its pixels are where these are large enough.
  void AddLabelsOfFlat(std::vector<Label>& labels, const LetterSize& letters) const;
  ///   split   the column from which on the pixels are the reference's
  void AddValuesOfPixels(std::vector<Label>& labels, const LetterSize& letters, double split) const;
  void ToggleSection();
  void MoveSection(int by);
  /// The pieces of the drawing, from the left: the scene; the cross section, where it is shown; and the panels, where
  /// they are, as high as all of it. Their status bar is above the former two.
  DrawingSize ViewSize() const;
  DrawingSize SectionSize() const;
  int WidthBesidePanels() const;     // at least 1
  int HeightBelowStatusBar() const;  // likewise
  bool IsOnSection(const R2::Point& position) const;
  /// A position in the drawing as one in the picture that SettingsOfPicture makes: beside a cross section there is less
  /// room for that, and the flat one is moved.
  R2::Point InPicture(const R2::Point& position) const;
  /// Where that picture is, in pixels of the drawing.
  PixelBox PlaceOfPicture() const { return FlatJob() ? flat_.Place(FittingPicture()) : FittingPicture(); }
  /// Where it is as large as there is room.
  PixelBox FittingPicture() const;
  void MakeSection();
  /// What is under the pointer; empty where that is not on the cross section.
  std::string TextOfSection() const;
  void SaveRays();
  void ToggleLive(std::optional<RenderMode> mode);
  void KeepReference();
  void Compare(TracedPictures::Comparing how);
  void ChangeExposure(double steps);
  void Reload();
  /// Those of the scene's own; throws where they cannot be.
  void TakeSettings(const Scene& scene);
  /// Of the file that was to be read.
  void TellProblems(const std::string& file, const std::exception& error);
  void ToggleHelp();
  void TellPanelsTheirParts() { panels_->SetParts({shows_panels_, shows_help_}); }
  void TogglePanels();
  void Open(const std::string& file);

  void TakeScene(std::shared_ptr<const LoadedScene> scene);
  /// For the scene and the settings as they are now.
  void MakeFaces();
  void AddNote(const std::string& note);
  void DebugPixelAt(const R2::Point& position);
  void ReportPixel();
  void SaveEnded(const RenderJob& job);
  void TellEndedLive(const RenderJob& job);
  void UpdateStatus();
  void ShowMessage(const std::string& message);
  void InvalidateLines() { lines_.reset(), needs_redraw_ = true; }
  std::optional<R3::Point> PointAt(const R2::Point& position) const;
  Navigator::PointAt PointFinder() const;
  std::array<R3::Point, 4> QuadCorners() const;
  /// Around all that is drawn in space.
  R3::Box BoxOfDrawing() const;
  /// Around the scene, and its lights when they are shown.
  R3::Box BoxToFrame() const;
  /// What keeps its size on the screen: the pivot and the pick.
  Lines MakeMarks() const;
  /// What is left of the message, from 1 to 0.
  double StrengthOfMessage() const;
  /// The pixel of the traced picture that is seen there on its quad.
  std::optional<std::pair<int, int>> PixelOnQuad(const R2::Point& position) const;
  bool ShowsQuad() const { return shows_quad_ && pictures_.Trace() && !pictures_.IsLive(); }
  /// Whether the view is that of the traced picture, whose frame would then be lines along the edges of the window.
  bool SeesAsTraced() const;
  Lines MakeLines() const;
  /// In pixels, as the density of the screen asks for.
  int LineWidth() const;
  std::vector<Label> MakeLabels() const;
  /// What the preview does not show of the camera; empty where it shows all.
  std::string TextOfProjection() const;
  /// The mistakes of the file that was to be read, which stay to be seen until it is right; empty without any.
  std::string TextOfProblems() const;
  std::string BoxesInWords() const;
  std::optional<FrameState::Picture> CoveringPicture() const;
  /// The distances of the nearest and the farthest surface that the preview shows, as mode zbuffer or depth needs them.
  ZBufferRange DepthsOfPreview() const;
  /// The background in the colors that the tracer's mode gives it.
  R2::Color BackgroundOfPreview() const;

  ViewerSettings settings_;
  ViewerHost& host_;
  std::shared_ptr<const LoadedScene> scene_;
  DrawingSpace space_;
  std::shared_ptr<const ScenePicture> faces_;
  FileWatch watch_;
  Bookmarks bookmarks_;
  Navigator navigator_;
  TracedPictures pictures_;
  RayInspector rays_;
  SectionView section_;
  FlatView flat_;
  SceneEditor editor_;
  ImageStrip images_;
  std::shared_ptr<const R2::Image> shown_image_;  // of these; null for the current one
  std::optional<Pick> pick_;
  std::optional<std::size_t> chosen_node_;
  const std::unique_ptr<Panels> panels_;
  std::unique_ptr<AcceleratorComparison> accelerators_;
  int accelerators_seen_ = 0;                                               // their version
  std::vector<std::unique_ptr<AcceleratorComparison>> ending_comparisons_;  // of scenes from before
  int scene_number_ = 0, options_number_ = 0;  // other ones for each scene, and after each change of an option
  TracedAs traced_as_;                         // the picture of key S
  std::string option_problem_;
  std::vector<SceneError> scene_problems_;
  std::string problem_file_;  // that was to be read when they were found

  DrawingSize size_;
  double scale_ = 1;  // of the screen
  bool shows_panels_ = false, shows_help_ = false, lists_scenes_ = false;
  bool shows_faces_ = true, shows_edges_ = false, shows_camera_ = false, shows_lights_ = false;
  bool shows_quad_ = true, shows_shadows_ = true;  // the latter where the scene has any
  Boxes boxes_ = Boxes::none;
  int box_level_;
  double exposure_steps_ = 0;         // each doubles the light
  bool arrows_move_section_ = false;  // else the pixel
  std::string message_, notes_;
  std::string status_;        // of the render that is shown
  double message_since_ = 0;  // seconds of ticks
  bool has_ticked_ = false, was_asked_to_quit_ = false;

  std::optional<Press> press_;
  double now_ = 0, last_look_at_files_ = 0, last_click_ = -1;  // seconds of ticks
  R2::Point last_click_at_, pointer_{-1, -1};
  std::uint64_t changes_seen_ = 0;
  std::shared_ptr<const Lines> lines_;  // null when they must be rebuilt
  bool lines_have_quad_frame_ = false;
  std::shared_ptr<const SliceAxes> section_drawing_;  // likewise
  DrawingSize section_size_;                          // of that
  std::vector<std::uint32_t> versions_;               // of the rows of frames when last seen
  struct StatusKey {
    std::uint64_t job = 0;
    int samples = 0;
    bool has_ended = false;
    friend bool operator==(const StatusKey&, const StatusKey&) = default;
  };
  StatusKey status_of_;       // what the status was made for
  double status_since_ = -1;  // seconds of ticks
  bool needs_redraw_ = true, is_closed_ = false;
};

}  // namespace ray
