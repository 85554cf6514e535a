#pragma once

#include <memory>
#include <string>
#include <vector>

#include "source/draw/FrameState.h"
#include "source/view/ViewerState.h"

namespace ray {

/// Makes the frame to be drawn. `lines`: those of MakeLines.
FrameState MakeFrame(ViewerState& viewer, std::shared_ptr<const Lines> lines);

/// Makes the texts over the view.
std::vector<Label> MakeLabels(const ViewerState& viewer);
/// The mistakes of the last file read, which stay visible until they are mended; empty without any.
std::string TextOfProblems(const ViewerState& viewer);

/// Boxes, lights, cameras and rays.
Lines MakeLines(const ViewerState& viewer);
/// Makes the lines that keep their size on the screen: the pivot, the pick, and the axis of moves.
Lines MakeMarks(const ViewerState& viewer);
/// Around the crop, which must exist, as deep in the view as the middle of the scene.
Lines FrameOfCrop(const ViewerState& viewer);
/// Returns true if a frame is drawn around the rendered image in space.
bool ShowsFrameOfQuad(const ViewerState& viewer);
/// Around all that is drawn in space.
R3::Box BoxOfDrawing(const ViewerState& viewer);

/// "hello.scn 512x512 4 of 16 samples 31 % 0.5 Mrays/s 12 s left"
std::string TitleOf(const ViewerState& viewer);
/// Describes the drawing, without the panels, in lines, for scripts.
std::string DescribeState(ViewerState& viewer);
/// Returns the text of the panels and the help, in lines; empty if they are hidden.
std::string TextOfPanels(ViewerState& viewer);

}  // namespace ray
