#pragma once

#include <exception>
#include <memory>
#include <string>

#include "source/view/ViewerState.h"

/// The scene that is shown: its settings, its edits, and other ones in its place.
namespace ray {

/// Shows it from now on; the camera stays.
void TakeScene(ViewerState& viewer, std::shared_ptr<const LoadedScene> scene);
/// Empty for the option's default. While the picture of key S is being rendered options stay as they are.
void ChangeOption(ViewerState& viewer, const std::string& name, const std::string& value);
/// Reads the scene with these texts in place of its files; camera, options and pictures stay. Returns why it could
/// not, and then shows what it did before; else nothing.
std::string ShowEdits(ViewerState& viewer, std::shared_ptr<const EditedFiles> texts);
/// Returns why it could not be written, else nothing.
std::string SaveScene(ViewerState& viewer, const std::string& file, const std::string& text);
/// Unless that would lose edits; then a message says so, and it is opened when it is asked for again. A picture is the
/// reference from then on.
void OpenScene(ViewerState& viewer, const std::string& file);
/// To the scene so many files behind this one in its folder, or before it.
void OpenNeighbor(ViewerState& viewer, int by);
void ToggleSceneList(ViewerState& viewer);
/// What the disk has, in place of edits.
void ReadFromDisk(ViewerState& viewer);
/// The files of the scene have changed.
void TellOfChangedFiles(ViewerState& viewer);
/// `file` was to be read, and has mistakes.
void TellProblems(ViewerState& viewer, const std::string& file, const std::exception& error);

}  // namespace ray
