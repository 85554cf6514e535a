#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "source/view/ViewerState.h"

namespace ray {

// Showing, choosing and closing.

/// Closes the uppermost open thing: the help, a scene being read, the flat image, the crop, the pick, the cross
/// section, the rendering.
void Peel(ViewerState& viewer);
/// Quits; if unsaved work would be lost, only when requested again.
void Quit(ViewerState& viewer);
/// `what`: its name in the message.
void Toggle(ViewerState& viewer, const char* what, bool SpaceOverlays::*shows);
void ToggleLights(ViewerState& viewer);
/// Bounding boxes: none, of the scene graph, of the accelerator.
void CycleBoxes(ViewerState& viewer);
void ShowBoxes(ViewerState& viewer, SpaceOverlays::Boxes boxes);
void ChangeBoxLevel(ViewerState& viewer, int by);
void ToggleHelp(ViewerState& viewer);
void TogglePanels(ViewerState& viewer);
void ShowPanels(ViewerState& viewer, const PanelSettings& look);
void SetPanelLook(ViewerState& viewer, const PanelSettings& look);
/// Chooses a node of the scene graph, an index into World::Nodes; std::nullopt for none.
void ChooseNode(ViewerState& viewer, std::optional<std::size_t> node);
/// Describes and chooses the object seen at a position of the image.
void PickAt(ViewerState& viewer, const R2::Point& position);
void FocusUnderPointer(ViewerState& viewer);

// The view: the camera and its bookmarks.

/// Prints the camera as a line of a scene, and copies it to the clipboard.
void PrintCamera(ViewerState& viewer);
/// Around the scene, and its lights when they are shown.
R3::Box BoxToFrame(const ViewerState& viewer);
void FrameScene(ViewerState& viewer);
void FramePicked(ViewerState& viewer);
void FrameChosenNode(ViewerState& viewer);
void Widen(ViewerState& viewer, double factor);
/// `name`: of the direction.
void LookAlong(ViewerState& viewer, const R3::Vector& towards, const R3::Vector& up, const std::string& name);
void ToggleTurntable(ViewerState& viewer);
void GoBack(ViewerState& viewer);
void GoForward(ViewerState& viewer);
void GoToSceneCamera(ViewerState& viewer);
/// Sets the pivot; std::nullopt for the center of the scene.
void SetPivot(ViewerState& viewer, const std::optional<R3::Point>& pivot);
void KeepBookmark(ViewerState& viewer, int digit);
void RecallBookmark(ViewerState& viewer, int digit);

// The current scene: its settings, its edits, and opening others.

/// Replaces the scene; the camera stays.
void TakeScene(ViewerState& viewer, std::shared_ptr<const LoadedScene> scene);
/// Empty for the option's default. While the image of key S is being rendered options stay as they are.
void ChangeOption(ViewerState& viewer, const std::string& name, const std::string& value);
/// Reads the scene with these texts in place of its files, and shows it; camera, options and images stay. Then calls
/// `then` with the problem if it could not, else with an empty text.
void ShowEdits(ViewerState& viewer, std::shared_ptr<const EditedFiles> texts,
               std::function<void(const std::string& problem)> then);
/// Returns the reason why it could not be written; empty if it was.
std::string SaveScene(ViewerState& viewer, const std::string& file, const std::string& text);
/// Opens a scene; if that would lose edits, a message says so, and it is opened when requested again. An image is the
/// reference from then on.
void OpenScene(ViewerState& viewer, const std::string& file);
/// Opens the scene `by` files after this one in its folder; negative: before it.
void OpenNeighbor(ViewerState& viewer, int by);
void ToggleSceneList(ViewerState& viewer);
/// Reads the scene from the disk, which discards edits.
void ReadFromDisk(ViewerState& viewer);
/// The files of the scene have changed.
void TakeChangedFiles(ViewerState& viewer);
/// Shows the mistakes of a file.
void ShowProblems(ViewerState& viewer, const std::string& file, const std::exception& error);

// Rendering of the view: by key S row by row, and live.

/// Renders the view row by row, or continues a stopped render.
void StartTrace(ViewerState& viewer);
/// Limits the next render to a rectangle between two positions in the drawing.
void Crop(ViewerState& viewer, const R2::Point& from, const R2::Point& to);
void ClearCrop(ViewerState& viewer);
/// Shows the traced image in a mode; std::nullopt for the mode of the settings.
void ShowTraced(ViewerState& viewer, std::optional<RenderMode> mode);
/// Shows the preview alone.
void ShowPreview(ViewerState& viewer);
void ToggleTraced(ViewerState& viewer);
/// Shows the traced image in that mode; if it already is, in the mode before.
void ToggleMode(ViewerState& viewer, RenderMode mode);
/// Stops or continues the traced image, and shows it.
void PauseOrResume(ViewerState& viewer);
void ToggleDenoising(ViewerState& viewer);
/// Saves and keeps the images that were completed since the last call; to be called regularly.
void TakeEndedJobs(ViewerState& viewer);
/// Begins to measure the costs of the accelerators for the current view, in the background.
void CompareAccelerators(ViewerState& viewer);
void StopComparingAccelerators(ViewerState& viewer);

// Finished images: exposure, the strip, and comparison.

/// Sets the exposure, in stops: each doubles the light.
void SetExposure(ViewerState& viewer, double steps);
/// Changes it by that many stops; 0 resets it.
void ChangeExposure(ViewerState& viewer, double steps);
/// Adds a finished image to the strip.
void KeepImage(ViewerState& viewer, const RenderJob& job);
/// Shows an image of the strip, which also becomes the reference; std::nullopt for the current image.
void ShowImage(ViewerState& viewer, std::optional<std::size_t> index);
std::optional<std::size_t> ShownImage(const ViewerState& viewer);
/// Shows the image `by` places further in the strip.
void FlipImages(ViewerState& viewer, int by);
void KeepReference(ViewerState& viewer);
/// Toggles the comparison.
void Compare(ViewerState& viewer, TracedImages::Comparing how);
void StopShowingReference(ViewerState& viewer);
/// Shows false colors, then FLIP.
void CompareInFalseColors(ViewerState& viewer);

// The rendered image shown flat.

void ToggleFlat(ViewerState& viewer);
/// Moves the image, or its slider.
void DragFlat(ViewerState& viewer, const R2::Point& from, const R2::Point& to, bool moves_slider);
bool TakesSlider(const ViewerState& viewer, const ButtonEvent& event);
void ZoomFlat(ViewerState& viewer, const ScrollEvent& event);

// Rays made visible.

/// Shows or hides the rays of every 25th pixel, of the rendered image if there is one.
void ToggleGrid(ViewerState& viewer);
/// Shows the rays of the pixel at a position of the drawing: of the rendered image if it is visible there, otherwise
/// of the view.
void DebugPixelAt(ViewerState& viewer, const R2::Point& position);
/// Shows rays of another tracer with ours, of the pixel that they start from, and names the first that differs.
///   file   their source
void ShowForeignRays(ViewerState& viewer, const std::string& file, ForeignRays foreign);
/// Goes to a neighboring pixel, or moves the cross section, whichever was used last.
void MoveByArrow(ViewerState& viewer, int right, int up);
void ForgetPixel(ViewerState& viewer);
void SaveRays(ViewerState& viewer);
/// Shows more or fewer bounces.
void StepBounce(ViewerState& viewer, int by);
/// One of the pixel's rays, by its number, to be lit up; nothing for none.
void ChooseRay(ViewerState& viewer, std::optional<std::size_t> ray);
void ToggleRays(ViewerState& viewer, ShownRays kind);
void ToggleNormals(ViewerState& viewer);
/// Sets the number of rays that are traced for inspection.
void SetDebugRays(ViewerState& viewer, const DebugRayCounts& counts);

// The cross section next to the view.

void ToggleSection(ViewerState& viewer);
/// Shows the cut along that plane, whatever was shown before.
void ShowSection(ViewerState& viewer, SlicePlane plane);
void NextPlane(ViewerState& viewer);
void MoveSection(ViewerState& viewer, int by);
/// Moves it to the row under the pointer, where it is along a row of the image and the pointer is over the view.
void FollowByCut(ViewerState& viewer);
/// Returns the width of all lines, in pixels: more on denser screens.
int LineWidth(const ViewerState& viewer);
/// Makes its drawing again where that is due; it is shown.
void MakeSection(ViewerState& viewer);
/// Describes the object under the pointer; empty if the pointer is not on the cross section.
std::string TextOfSection(const ViewerState& viewer);

}  // namespace ray
