#pragma once

#include "R2/Color.h"
#include "R2/Image.h"
#include "R2/Plane.h"

namespace R2 {

/// Maps a number from 0 (black) to 1 (white) to a color whose brightness increases with the number. Its luminance, with
/// the course's weights, equals the number within 0.001, so that the order survives grayscale printing and color
/// blindness. Numbers out of range are clamped; NaN becomes black.
///   source  Green, A colour scheme for the display of astronomical intensity images (2011): cubehelix, with start 0.5,
///           -1.5 rotations, hue 1, gamma 1
Color RampColor(double number);

/// Returns a false-color image of numbers from 0 to 1.
Image RampImage(const Plane& numbers);

}  // namespace R2
