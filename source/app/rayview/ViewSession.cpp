#include "source/app/rayview/ViewSession.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <span>
#include <thread>
#include <utility>

#include "R2/ImageFile.h"
#include "source/app/Interrupt.h"
#include "source/app/Status.h"
#include "source/app/files/ReadInputs.h"
#include "source/app/options/OptionTable.h"
#include "source/app/options/RayproCommand.h"
#include "source/app/options/SceneSettings.h"
#include "source/app/rayview/PanelHabits.h"
#include "source/app/rayview/PanelOptions.h"
#include "source/app/rayview/RecentScenes.h"
#include "source/app/rayview/SaveImage.h"
#include "source/app/rayview/StoppedRender.h"
#include "source/app/report/Messages.h"
#include "source/draw/MotionDetail.h"
#include "source/draw/contexts/Context.h"
#include "source/draw/gl/Drawer.h"
#include "source/parse/Text.h"
#include "source/render/forecast/SecondsOf.h"
#include "source/text/Quoting.h"
#include "source/view/EventScript.h"
#include "source/view/Viewer.h"
#include "source/view/commands/Commands.h"

namespace ray {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double seconds_while_busy = 1.0 / 60, seconds_while_idle = 0.25;  // between two checks

std::string AllOf(std::istream& in) { return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()}; }

std::span<const unsigned char> BytesOf(const std::string& text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

Text ReadScript(const std::string& name) {
  if (name == "-") return {"standard input", AllOf(std::cin)};
  return {name, Contents(name)};
}

std::string NameOfFile(const std::string& path) { return std::filesystem::path(path).filename().string(); }

/// Reads an image; returns an empty image if the file is not one.
ReferenceImage ReadImageOrNone(const std::string& name) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(name, error)) return {};
  std::ifstream in(name, std::ios::binary);
  const std::string bytes = AllOf(in);
  try {
    R2::DecodedImage decoded = R2::DecodeImage(BytesOf(bytes));
    PrintWarnings(name, decoded.warnings);
    return ReferenceOf(std::move(decoded));
  } catch (const R2::ImageError&) {
    return {};
  }
}

/// Returns the first of "rays1.obj" and so on that does not exist.
std::string FreeRaysName() {
  for (int i = 1;; ++i) {
    std::string name = "rays" + std::to_string(i) + ".obj";
    std::error_code error;
    if (!std::filesystem::exists(name, error)) return name;
  }
}

ViewerSettings SettingsFor(const ViewerOptions& options) {
  ViewerSettings settings{options.files.scene, options.parse, options.accelerator, options.render, {}};
  settings.shows_bar = IsLookedAt(options.view);
  settings.budget_of_rest = IsLookedAt(options.view) && options.default_image.has_its_samples;
  settings.shows_traced = options.view.preview == "auto" ? IsLookedAt(options.view) && !options.view.exit_immediately
                                                         : options.view.preview == "traced";
  return settings;
}

/// Returns the file of the user's panel settings; empty for scripts and recordings, which must not depend on them.
std::string HabitsFile(const ViewerOptions& options) {
  return IsLookedAt(options.view) && options.view.record.empty() ? PanelHabitsFile() : std::string();
}

ViewerSettings WithReference(ViewerSettings settings, const std::string& reference) {
  if (reference.empty()) return settings;
  Contents(reference);  // reports a missing file
  settings.reference = ReadImageOrNone(reference);
  if (!settings.reference) throw SceneErrors({ErrorIn(reference, "the file cannot be read as an image")});
  return settings;
}

/// Reads the rays of another tracer; nothing without a file. Throws SceneErrors.
std::optional<ForeignRays> ForeignRaysOf(const std::string& file) {
  if (file.empty()) return {};
  return ReadForeignRays({file, Contents(file)});
}

/// Returns the initial panel settings; `theme` is one of panel_themes.
PanelSettings FirstLook(PanelSettings habits, const std::string& theme) {
  if (theme != "off") habits.theme = theme == "light" ? PanelTheme::light : PanelTheme::dark;
  return habits;
}

ViewerSettings WithLook(ViewerSettings settings, const PanelSettings& look) {
  settings.panels = look;
  return settings;
}

/// Returns true if the option affects only the image of a view at rest.
bool IsOfBudget(const std::string& option) { return FindOption(Program::rayview, option)->facts.Has(Fact::budget); }

using PanelTriangle = std::array<PanelDrawing::Corner, 3>;

/// Returns the visible triangles of panels, sorted. Panels also draw the item with the focus, even out of view.
std::vector<PanelTriangle> VisibleTriangles(const PanelDrawing& panels) {
  std::vector<PanelTriangle> visible;
  for (const PanelDrawing::Part& part : panels.parts)
    for (std::size_t i = part.first; i < part.first + part.count; i += 3) {
      const auto corner = [&](std::size_t k) { return panels.corners[panels.indices[i + k]]; };
      const PanelTriangle t{corner(0), corner(1), corner(2)};
      const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
      const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
      if (left < static_cast<float>(part.right) && right > static_cast<float>(part.left) &&
          top < static_cast<float>(part.bottom) && bottom > static_cast<float>(part.top))
        visible.push_back(t);
    }
  std::ranges::sort(visible, std::less());
  return visible;
}

/// Records events as a script that repeats them. Times between events are added up.
class Recorder {
 public:
  explicit Recorder(const std::optional<OutputFile>& file) : file_(file) {}

  void Keep(const Event& event) {
    if (!file_) return;
    if (const auto* tick = std::get_if<TickEvent>(&event)) {
      passed_ += tick->seconds;
      return;
    }
    if (passed_ > 0) text_ += ScriptLine(TickEvent{passed_});
    passed_ = 0;
    text_ += ScriptLine(event);
  }
  /// A click in the panels, which finds its place again wherever they are scrolled to.
  void Keep(const ClickPanel& panel) {
    if (passed_ > 0) text_ += ScriptLine(TickEvent{passed_});
    passed_ = 0;
    text_ += "panel " + panel.name + "\n";
  }
  void Write() const {
    if (!file_) return;
    // Messages also fade after the last event.
    const std::string text = text_ + (passed_ > 0 ? ScriptLine(TickEvent{passed_}) : "");
    WriteWhole(*file_, BytesOf(text));
  }

 private:
  const std::optional<OutputFile>& file_;
  std::string text_;
  double passed_ = 0;
};

/// A viewer, its drawing context, and the files around them.
class Session : public ViewerHost {
 public:
  Session(const ViewerOptions& asked, const ViewerOptions& options, const ViewOutputs& outputs,
          std::shared_ptr<const LoadedScene> scene, std::unique_ptr<Window> window)
      : asked_(asked),
        options_(options),
        outputs_(outputs),
        window_(options.view.headless || window ? std::move(window)
                                                : MakeWindow(options.render.width, options.render.height,
                                                             "rayview " + NameOfFile(options.files.scene))),
        offscreen_(options.view.headless ? MakeOffscreenContext(options.view.context) : nullptr),
        painter_(window_ ? Canvas::Target::window : Canvas::Target::own),
        drawer_(painter_),
        habits_file_(HabitsFile(options)),
        first_look_(FirstLook(LoadPanelHabits(habits_file_), options.view.panels)),
        viewer_(WithLook(WithReference(SettingsFor(options), options.view.reference), first_look_), std::move(scene),
                *this),
        foreign_(ForeignRaysOf(options.view.rays)),
        recorder_(outputs_.record),
        recent_(IsLookedAt(options.view) && options.view.record.empty() ? RecentScenesFile() : std::string()) {
    if (!options.files.scene.empty()) recent_.Add(options.files.scene);
    if (options.view.panels != "off") viewer_.ShowPanels(first_look_);
    if (!options.files.scene.empty()) return;
    ToggleSceneList(viewer_.state());
    viewer_.ShowMessage("choose a scene, or drop a file here; H: help");
  }

  /// Shows mistakes in the file, because of which another scene is displayed.
  void ShowMistakes(const SceneErrors& mistakes) { viewer_.ShowMistakes(mistakes); }

  int Run() {
    if (window_) Happen(ResizeEvent{window_->Width(), window_->Height(), window_->Scale()});
    if (foreign_) ShowForeignRays(viewer_.state(), options_.view.rays, *foreign_);
    if (!options_.view.events.empty())
      Follow(ReadScript(options_.view.events));
    else if (window_ && !options_.view.exit_immediately)
      Interact();
    if (viewer_.state().settings.shows_traced && options_.view.exit_immediately) ShowWholeImage(false);
    Draw();
    for (const auto& output : {outputs_.output_image, outputs_.screenshot})
      if (output) Attempt([&] { return SaveDrawingTo(*output); });
    if (outputs_.record)
      Attempt([&] {
        RefuseInputs(*outputs_.record, inputs_);
        recorder_.Write();
        return std::string();
      });
    recent_.Save();
    if (!habits_file_.empty() && viewer_.state().panels->Look() != first_look_)
      SavePanelHabits(habits_file_, viewer_.state().panels->Look());
    const int end = StopSignal() != 0 ? status::killed_by + StopSignal() : status_;
    if (viewer_.IsReading()) std::_Exit(end);  // of a scene that nobody will see; it cannot be stopped
    return end;
  }

  std::string SaveTraced(const RenderJob& job) override {
    const ViewerOptions options = OptionsOf(job);
    stopped_.Finished(job, options);
    return Attempt([&] {
      if (outputs_.image) RefuseInputs(outputs_.image->file, FilesRead());
      std::string line = ray::SaveTraced(outputs_.image ? &*outputs_.image : nullptr, options, job.scene(),
                                         *job.Result(), job.Seconds());
      if (!line.empty() && line.back() == '\n') line.pop_back();
      if (!options_.quiet) Print(line);
      return line;
    });
  }
  std::string KeepStopped(const RenderJob& job) override { return stopped_.Keep(job, OptionsOf(job)); }
  void SaveDrawing() override { wants_drawing_ = true; }
  std::string SaveRays(const std::string& obj) override {
    return Attempt([&] {
      const std::string name = FreeRaysName();
      WriteWhole(CheckOutput(name, {}), BytesOf(obj));
      return "rays saved to " + name;
    });
  }
  std::string SaveText(const std::string& file, const std::string& text) override {
    try {
      WriteWhole(CheckOutput(file, FilesRead()), BytesOf(text));
      return {};
    } catch (const OutputError& error) {
      return error.what();
    }
  }
  std::string SaveScene(const std::string& file, const std::string& text) override {
    try {
      WriteWhole(CheckOutput(file, {}), BytesOf(text));
      return {};
    } catch (const OutputError& error) {
      return error.what();
    }
  }
  std::vector<std::string> RecentScenes() override { return recent_.Files(); }
  ReferenceImage ReadImage(const std::string& file) override {
    inputs_.push_back(file);
    return ReadImageOrNone(file);
  }
  void SetClipboard(const std::string& text) override {
    if (window_) window_->SetClipboard(text);
  }
  void Print(const std::string& line) override {
    WriteStandardOutput(!line.empty() && line.back() == '\n' ? line : line + "\n");
  }
  std::vector<ShownOption> ShownOptions() override { return OptionsOfPanels(options_); }
  ViewerSettings ChangeOption(const std::string& name, const std::string& value) override {
    options_ = WithOption(viewer_.scene().parsed.scene, options_, name, value);
    changes_.emplace_back(name, value);
    return SettingsFor(options_);
  }
  std::optional<ViewerSettings> SettingsWith(const Scene& scene) override {
    for (const std::string& file : scene.files)  // an edited scene repeats the same ones
      if (std::ranges::find(inputs_, file) == inputs_.end()) inputs_.push_back(file);
    if (!scene.files.empty()) recent_.Add(scene.files.front());
    ViewerOptions options = WithSettingsOf(scene, asked_);
    for (const auto& [name, value] : changes_) options = WithOption(scene, options, name, value);
    options_ = std::move(options);
    return SettingsFor(options_);
  }
  std::string CommandFor(const RenderSettings& settings) override {
    ViewerOptions options = options_;
    options.render = settings;
    options.render.threads = options_.render.threads;
    options.render.budget = WithoutLimits(settings.budget);  // key S takes all samples
    std::erase_if(options.given, IsOfBudget);
    if (options.files.image.empty()) options.files.image = "image.png";
    return RayproCommand(options);
  }

 private:
  /// Returns the options that produce the image of a job of key S.
  ViewerOptions OptionsOf(const RenderJob& job) const {
    ViewerOptions options = options_;
    options.render = job.Settings();
    options.render.threads = options_.render.threads;  // a job stores the number of threads used
    std::erase_if(options.given, IsOfBudget);
    return options;
  }

  /// Returns the result of `save`, or its error message; after an error the program ends with that status.
  template <typename Save>
  std::string Attempt(const Save& save) {
    try {
      return save();
    } catch (const std::exception& error) {
      status_ = status::cannot_write;
      PrintError("rayview: " + std::string(error.what()));
      return error.what();
    }
  }

  /// Saves the drawing without a message; throws OutputError if that would replace a file dropped on the window.
  std::string SaveDrawingTo(const ImageOutput& output) {
    RefuseInputs(output.file, FilesRead());
    ray::SaveDrawing(output, painter_.canvas.Read(), options_.encoding);
    return {};
  }

  /// The event with its position, if it has one, counted from the other end of the drawing.
  Event Flipped(Event event) const {
    std::visit(
        [&](auto& e) {
          if constexpr (requires { e.y; }) e.y = viewer_.Size().height - e.y;
        },
        event);
    return event;
  }

  /// Returns false if the event does nothing; it is not recorded then.
  bool Happen(const Event& event) {
    const Event recorded = Flipped(event);
    const bool is_used = viewer_.Handle(event);
    if (is_used) recorder_.Keep(recorded);
    if (!IsLookedAt(options_.view)) viewer_.WaitForScene();  // the next step of a script is for the scene read
    if (std::exchange(wants_drawing_, false)) SaveScreenshot();
    return is_used;
  }
  /// Saves the drawing under a free name, and shows that name.
  void SaveScreenshot() {
    Draw();
    viewer_.ShowMessage(Attempt([&] {
      // JPEG degrades letters and lines.
      const ImageOutput place = ClaimImageName(R2::FormatForName("image.png") ? "png" : "jpg");
      ray::SaveDrawing(place, painter_.canvas.Read(), options_.encoding);
      Print("screenshot saved to " + place.file.name);
      return "screenshot saved to " + place.file.name;
    }));
  }

  void Draw() {
    viewer_.WaitForFaces();
    viewer_.Update();
    drawer_.Draw(viewer_.Show());
    if (!window_) return;
    window_->Show();
    ShowTitle();
  }
  /// Draws in fast mode while the view moves, and in full once it rests.
  void DrawForHand() {
    const bool has_news = viewer_.Update();
    const double now = SecondsSince(start_);
    const auto refinement = detail_.RefinementTime();
    if (has_news || (refinement && now >= *refinement)) {
      FrameState shown = viewer_.Show();
      shown.detail = detail_.For(shown, now);
      drawer_.Draw(shown);
      Canvas::Finish();
      detail_.Took(SecondsSince(start_) - now);
      window_->Show();
    }
    ShowTitle();
  }
  /// Returns the time until the next check, unless an event comes earlier.
  double SecondsToWait() const {
    if (viewer_.IsBusy() || viewer_.navigator().IsFlying()) return seconds_while_busy;
    const auto refinement = detail_.RefinementTime();
    if (!refinement) return seconds_while_idle;
    return std::clamp(*refinement - SecondsSince(start_), 0.0, seconds_while_idle);
  }
  void ShowTitle() {
    const std::string title = "rayview " + viewer_.Title() + " " + window_->Name();
    if (title != title_) window_->SetTitle(title);
    title_ = title;
  }

  void Interact() {
    auto last = Clock::now();
    DrawForHand();
    while (!viewer_.IsClosed() && StopSignal() == 0) {
      const std::vector<Event> events = window_->Wait(SecondsToWait());
      Happen(TickEvent{SecondsSince(last)});
      last = Clock::now();
      for (const Event& event : events) Happen(event);
      DrawForHand();
    }
  }

  /// Reports the steps that do nothing, and continues.
  void Follow(const Text& script) {
    std::size_t closing_line = 0, reported_line = 0;  // a line may be several steps
    for (const ScriptStep& step : ReadEventScript(script)) {
      if (StopSignal() != 0) return;
      const bool is_late = viewer_.IsClosed() && step.word.line != closing_line;
      if (!viewer_.IsClosed()) closing_line = step.word.line;
      const std::string problem = is_late ? "the viewer was closed before this step" : Do(step);
      if (!problem.empty() && std::exchange(reported_line, step.word.line) != step.word.line) {
        status_ = status::failed;
        PrintError(ErrorAt(script, step.word, problem).Format());
      }
      if (is_late) return;
    }
  }
  /// Carries out a step. Returns the reason if it does nothing, or an empty text.
  std::string Do(const ScriptStep& step) {
    if (const auto* event = std::get_if<Event>(&step.what)) return Do(y_is_from_bottom_ ? *event : Flipped(*event));
    if (const auto* panel = std::get_if<ClickPanel>(&step.what)) return Click(*panel);
    if (const auto* rows = std::get_if<WaitForRows>(&step.what)) return WaitFor(*rows);
    if (const auto* origin = std::get_if<Origin>(&step.what)) {
      y_is_from_bottom_ = origin->is_bottom;
    } else if (std::holds_alternative<WaitForTrace>(step.what)) {
      WaitUntilIdle();
      if (!viewer_.Traced().Job()) return "no image is being rendered";
    } else if (std::holds_alternative<WaitForImage>(step.what)) {
      ShowWholeImage();
    } else if (const auto* wait = std::get_if<WaitSeconds>(&step.what)) {
      for (const auto start = Clock::now(); SecondsSince(start) < wait->seconds && StopSignal() == 0;) Pause();
    } else if (const auto* screenshot = std::get_if<Screenshot>(&step.what)) {
      Draw();
      ray::SaveDrawing(CheckImageOutput(screenshot->file, FilesRead()), painter_.canvas.Read(), options_.encoding);
    } else {
      viewer_.Update();
      Print(viewer_.Describe());
    }
    return {};
  }
  std::string Do(const Event& event) {
    const auto* drop = std::get_if<DropEvent>(&event);
    if (std::error_code error; drop && !std::filesystem::exists(drop->file, error)) return "no such file";
    const auto* button = std::get_if<ButtonEvent>(&event);
    const auto* scroll = std::get_if<ScrollEvent>(&event);
    if ((button && button->is_pressed && !IsInDrawing(button->x, button->y)) ||
        (scroll && !IsInDrawing(scroll->x, scroll->y)))
      return "this is outside of the drawing, which has " + std::to_string(viewer_.Size().width) + " x " +
             std::to_string(viewer_.Size().height) + " pixels";
    const bool is_used = Happen(event);
    DrawNewsInWindow();
    if (is_used) return {};
    const auto* key = std::get_if<KeyEvent>(&event);
    return key ? "key " + NameOf(key->key, key->modifiers) + " has no function" : "no field takes text";
  }
  bool IsInDrawing(double x, double y) const {
    return x >= 0 && y >= 0 && x <= viewer_.Size().width && y <= viewer_.Size().height;
  }
  std::string WaitFor(const WaitForRows& rows) {
    const RenderJob* const trace = viewer_.Traced().Trace();
    if (!trace) return "no image is being rendered";
    while (viewer_.Traced().IsTracing() && trace->RowsDone() < rows.rows && StopSignal() == 0) Pause();
    if (trace->RowsDone() >= rows.rows) return {};
    return "the render ended after " + std::to_string(trace->RowsDone()) + " rows";
  }
  /// `ticks`: time passes, as it does for a user who looks on.
  void WaitUntilIdle(bool ticks = true) {
    viewer_.Update();
    while (viewer_.IsBusy() && StopSignal() == 0) Pause(ticks);
  }
  /// Shows the traced image, and waits until it is complete.
  void ShowWholeImage(bool ticks = true) {
    if (!viewer_.Traced().IsLive()) ShowTraced(viewer_.state(), {});
    WaitUntilIdle(ticks);
    viewer_.Show();  // it may request the depths of the image
    WaitUntilIdle(ticks);
  }
  /// Returns all files read so far: scenes and images may be dropped and reloaded after the outputs were checked at the
  /// start.
  std::vector<std::string> FilesRead() const {
    std::vector<std::string> files = inputs_;
    const std::vector<std::string>& of_scene = viewer_.scene().parsed.scene.files;
    files.insert(files.end(), of_scene.begin(), of_scene.end());
    for (const std::string& file : {options_.view.events, options_.view.reference, options_.view.rays})
      if (!file.empty()) files.push_back(file);
    return files;
  }

  std::string Click(const ClickPanel& panel) {
    viewer_.Show();  // updates positions
    viewer_.Reveal(panel.name);
    const auto& items = viewer_.ItemsOfPanels();
    const auto item = std::ranges::find_if(items, [&](const PanelItem& i) { return i.name.starts_with(panel.name); });
    if (item == items.end()) return "the panels show no " + Quoted(panel.name);
    const double x = item->x, y = item->y;
    recorder_.Keep(panel);
    viewer_.Handle(MoveEvent{x, y});  // the item under the pointer lights up without a click
    const auto drawn = VisibleTriangles(*viewer_.Show().panels);
    const std::string described = viewer_.DescribeWithoutPanels();
    viewer_.Handle(ButtonEvent{Button::left, true, x, y, {}});
    viewer_.Handle(ButtonEvent{Button::left, false, x, y, {}});
    DrawNewsInWindow();
    const auto now = viewer_.Show().panels;
    if (viewer_.DescribeWithoutPanels() != described || !now || VisibleTriangles(*now) != drawn) return {};
    return "a click on " + Quoted(panel.name) + " changes nothing";
  }
  void DrawNewsInWindow() {
    const bool has_news = viewer_.Update();
    if (!window_) return;
    if (has_news) {
      drawer_.Draw(viewer_.Show());
      window_->Show();
    }
    ShowTitle();
  }
  /// Lets a moment pass; `ticks`: as for a user who watches.
  void Pause(bool ticks = true) {
    const auto before = Clock::now();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (ticks) Happen(TickEvent{SecondsSince(before)});
    DrawNewsInWindow();
  }

  const ViewerOptions asked_;                                 // from the command line, without the scene's settings
  ViewerOptions options_;                                     // with these, and as changed in panels
  std::vector<std::pair<std::string, std::string>> changes_;  // the changes made there
  const ViewOutputs outputs_;
  std::vector<std::string> inputs_;  // read since the start
  const std::unique_ptr<Window> window_;
  const std::unique_ptr<Context> offscreen_;
  Painter painter_;
  Drawer drawer_;
  const std::string habits_file_;  // empty if there are none
  const PanelSettings first_look_;
  Viewer viewer_;
  const std::optional<ForeignRays> foreign_;
  Recorder recorder_;
  StoppedRender stopped_;
  ray::RecentScenes recent_;
  const Clock::time_point start_ = Clock::now();
  MotionDetail detail_;
  std::string title_;
  bool wants_drawing_ = false, y_is_from_bottom_ = false;
  int status_ = status::done;
};

}  // namespace

bool IsLookedAt(const ViewOptions& view) { return !view.headless && view.events.empty(); }

int View(const ViewerOptions& asked, const ViewerOptions& options, const ViewOutputs& outputs,
         std::shared_ptr<const LoadedScene> scene, const SceneErrors* mistakes, std::unique_ptr<Window> window) {
  CatchInterrupts();
  // The scene's setting of the image size is known only now.
  if (options.render.width != asked.render.width || options.render.height != asked.render.height) window.reset();
  Session session(asked, options, outputs, std::move(scene), std::move(window));
  if (mistakes) session.ShowMistakes(*mistakes);
  return session.Run();
}

}  // namespace ray
