#pragma once

#include <optional>

#include "source/view/ViewerState.h"

/// Finished images: their exposure, the strip of them, and how they are compared.
namespace ray {

/// In stops: each doubles the light.
void SetExposure(ViewerState& viewer, double steps);
/// By so many stops; 0 resets it.
void ChangeExposure(ViewerState& viewer, double steps);
/// A finished image goes to the strip of them.
void KeepImage(ViewerState& viewer, const RenderJob& job);
/// One of the strip in place of the current image; nothing for the current one. It is the reference as well.
void ShowImage(ViewerState& viewer, std::optional<std::size_t> index);
std::optional<std::size_t> ShownImage(const ViewerState& viewer);
/// To the image so many further on in the strip.
void FlipImages(ViewerState& viewer, int by);
void KeepReference(ViewerState& viewer);
/// Toggles the comparison.
void Compare(ViewerState& viewer, TracedPictures::Comparing how);
void StopShowingReference(ViewerState& viewer);
/// In false colors, and then by FLIP.
void CompareInFalseColors(ViewerState& viewer);

}  // namespace ray
