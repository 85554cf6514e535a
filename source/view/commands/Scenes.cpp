#include "source/view/commands/Commands.h"

#include <filesystem>
#include <fstream>
#include <utility>

#include "source/view/edit/SceneFiles.h"

namespace ray {
namespace {

/// Returns true if a file contains rays of another tracer, by its name and its first 64 KiB.
bool HoldsForeignRays(const std::string& file) {
  std::string beginning(1 << 16, ' ');
  if (std::error_code error; file.ends_with(".obj") && std::filesystem::is_regular_file(file, error))
    std::ifstream(file, std::ios::binary).read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return IsForeignRays({file, beginning});
}

void MakeFaces(ViewerState& viewer) {
  viewer.traced.SetEncoding({viewer.settings.render.srgb, viewer.settings.render.quantization});
  viewer.scene.MakeFaces(viewer.settings.render);
}

/// Applies the settings of a scene; throws if they are impossible.
void TakeSettings(ViewerState& viewer, const Scene& scene) {
  const auto settings = viewer.host.SettingsWith(scene);
  if (!settings) return;
  viewer.settings.render = settings->render;
  viewer.settings.budget_of_rest = settings->budget_of_rest;
}

using EditedTexts = std::shared_ptr<const EditedFiles>;
using ShowScene = std::function<void(std::shared_ptr<const LoadedScene>)>;

FileReader::Read ReadingOf(const std::string& file, const ParseOptions& parse, const AcceleratorSettings& how,
                           ShowScene show) {
  return [=]() -> FileReader::Show {
    return [show, scene = std::make_shared<const LoadedScene>(file, parse, how)] { show(scene); };
  };
}

/// Reads the scene again, from the disk or, if there are any, from edited texts. The scene that is shown stays until
/// the new one can be read.
void Reload(ViewerState& viewer, EditedTexts texts) {
  ParseOptions parse = viewer.settings.parse;
  parse.edited = texts;
  const auto show = [&viewer, texts](std::shared_ptr<const LoadedScene> scene) {
    TakeSettings(viewer, scene->parsed.scene);
    if (!texts) viewer.editor.Forget();
    viewer.settings.parse.edited = texts;
    const bool showed_nothing = viewer.scene.world().Instances().empty();
    TakeScene(viewer, std::move(scene));
    if (showed_nothing) viewer.navigator.Go(viewer.scene.Parsed().camera);
    viewer.notices.Show("scene reloaded" + viewer.NotesAfterMessage());
  };
  const std::string& file = viewer.settings.scene;
  viewer.reader.Begin(file, texts != nullptr, ReadingOf(file, parse, viewer.settings.accelerator, show),
                      [&viewer](const std::exception& error) { ShowProblems(viewer, viewer.settings.scene, error); });
}

}  // namespace

void TakeScene(ViewerState& viewer, std::shared_ptr<const LoadedScene> scene) {
  viewer.scene.Take(std::move(scene));
  viewer.selection = {};
  viewer.accelerators.Forget();
  viewer.navigator.SetBox(viewer.scene.Parsed().root.bounds);
  MakeFaces(viewer);
  viewer.watch.Watch(viewer.scene.Parsed().files);
  viewer.rays.ForgetAll();
  viewer.section_pane.drawing.reset();
  viewer.traced.Touch();
  viewer.notices.RedrawLines();
}

void ChangeOption(ViewerState& viewer, const std::string& name, const std::string& value) {
  // What is saved at its end is to be the image of one command.
  if (viewer.traced.IsUnsaved()) {
    viewer.option_changes.problem = "an image is being rendered; Escape stops it";
    return viewer.notices.Show(viewer.option_changes.problem);
  }
  if (viewer.reader.IsReadingEdit()) {  // which reading with another option would replace
    viewer.option_changes.problem = "wait: " + viewer.reader.Describe();
    return viewer.notices.Show(viewer.option_changes.problem);
  }
  ViewerSettings changed;
  try {
    changed = viewer.host.ChangeOption(name, value);
  } catch (const std::exception& error) {
    viewer.option_changes.problem = error.what();
    return viewer.notices.Show(viewer.option_changes.problem);
  }
  viewer.option_changes.problem.clear();
  changed.parse.edited = viewer.settings.parse.edited;
  ++viewer.option_changes.number;
  const bool is_read_again =
      changed.parse != viewer.settings.parse || changed.accelerator != viewer.settings.accelerator;
  viewer.settings.parse = changed.parse;
  viewer.settings.accelerator = changed.accelerator;
  viewer.settings.render = changed.render;
  viewer.settings.budget_of_rest = changed.budget_of_rest;
  if (is_read_again) return Reload(viewer, viewer.settings.parse.edited);
  MakeFaces(viewer);
  viewer.traced.Touch();
  viewer.notices.RedrawLines();
  viewer.notices.Show("-" + name + " " + value);
}

void ShowEdits(ViewerState& viewer, std::shared_ptr<const EditedFiles> texts,
               std::function<void(const std::string& problem)> then) {
  ParseOptions parse = viewer.settings.parse;
  parse.edited = texts;
  const auto show = [&viewer, texts, then](std::shared_ptr<const LoadedScene> scene) {
    const bool was_in_place = !viewer.HasMovedCamera();
    TakeSettings(viewer, scene->parsed.scene);
    viewer.settings.parse.edited = texts;
    TakeScene(viewer, std::move(scene));
    // Whoever looks through the scene's camera goes with it.
    if (was_in_place && viewer.HasMovedCamera()) viewer.navigator.Go(viewer.scene.Parsed().camera);
    then({});
  };
  const auto refuse = [then](const std::exception& error) {
    const auto* errors = dynamic_cast<const SceneErrors*>(&error);
    then(errors && !errors->All().empty() ? errors->All().front().message : error.what());
  };
  const std::string& file = viewer.settings.scene;
  viewer.reader.Begin(file, true, ReadingOf(file, parse, viewer.settings.accelerator, show), refuse);
}

std::string SaveScene(ViewerState& viewer, const std::string& file, const std::string& text) {
  std::string problem = viewer.host.SaveScene(file, text);
  viewer.watch.Watch(viewer.scene.Parsed().files);  // it is known already
  return problem;
}

void ReadFromDisk(ViewerState& viewer) {
  if (!viewer.editor.MayLose("reload the scene")) return;
  Reload(viewer, nullptr);
}

void TakeChangedFiles(ViewerState& viewer) {
  if (!viewer.editor.HasUnsaved() && !viewer.reader.IsReadingEdit()) return ReadFromDisk(viewer);
  viewer.notices.Show("the scene has changed on the disk; your changes stay, Control+S saves them");
}

void ShowProblems(ViewerState& viewer, const std::string& file, const std::exception& error) {
  viewer.scene.KeepMistakes(file, error);
  viewer.host.Print(error.what());
  const std::string text = error.what();
  viewer.notices.Show(text.substr(0, text.find('\n')));
}

void OpenScene(ViewerState& viewer, const std::string& file) {
  const bool holds_rays = HoldsForeignRays(file), is_scene = !holds_rays && !R2::FormatForName(file);
  if (!is_scene && viewer.reader.IsBusy()) return viewer.notices.Show("wait: " + viewer.reader.Describe());
  if (is_scene && !viewer.editor.MayLose("open " + file)) return;
  ParseOptions unedited = viewer.settings.parse;
  unedited.edited.reset();
  const auto show = [&viewer, file](std::shared_ptr<const LoadedScene> scene) {
    TakeSettings(viewer, scene->parsed.scene);
    viewer.settings.scene = file;
    viewer.settings.parse.edited.reset();
    viewer.editor.Forget();
    viewer.bookmarks = Bookmarks(file);
    viewer.traced.ForgetTrace();
    viewer.flat.Hide();
    TakeScene(viewer, std::move(scene));
    viewer.navigator.SetPivot({});
    viewer.navigator.Go(viewer.scene.Parsed().camera);
    viewer.notices.Show("opened " + file + viewer.NotesAfterMessage());
  };
  const auto read_scene = ReadingOf(file, unedited, viewer.settings.accelerator, show);
  const auto read = [&viewer, file, holds_rays, read_scene]() -> FileReader::Show {
    if (const ReferenceImage image = viewer.host.ReadImage(file))
      return [&viewer, file, image] {
        viewer.host.NoteRead(file);
        viewer.traced.SetReference(image);
        viewer.notices.Show("the reference is " + file);
      };
    if (!holds_rays) return read_scene();
    const auto text = ReadSceneFile(file);
    if (!text) throw SceneErrors({ErrorIn(file, "the file cannot be read")});
    return [&viewer, file, rays = ReadForeignRays({file, *text})] { ShowForeignRays(viewer, file, rays); };
  };
  viewer.reader.Begin(file, false, read,
                      [&viewer, file](const std::exception& error) { ShowProblems(viewer, file, error); });
}

void OpenNeighbor(ViewerState& viewer, int by) {
  const std::string& from = viewer.reader.IsBusy() ? viewer.reader.File() : viewer.settings.scene;
  const std::string file = NeighborOf(from, ScenesBeside(from), by);
  if (file.empty()) return viewer.notices.Show("there is no other scene in the folder");
  OpenScene(viewer, file);
}

void ToggleSceneList(ViewerState& viewer) {
  viewer.shows.scenes = !viewer.shows.scenes;
  if (viewer.shows.scenes && !viewer.shows.panels) ShowPanels(viewer, viewer.panels->Look());
  if (viewer.shows.panels)
    viewer.notices.Show(viewer.shows.scenes ? "scenes to open are in the panels" : "the list of scenes is closed");
}

}  // namespace ray
