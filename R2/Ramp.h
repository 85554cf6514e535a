#pragma once

#include "R2/Color.h"
#include "R2/Image.h"
#include "R2/Plane.h"

namespace R2 {

/// A color for a number from 0 (black) to 1 (white), brighter with the number: its luminance, as the course weighs
/// channels, is the number within 0.001, so that order survives a gray print and color-blind eyes. Numbers outside,
/// and NaN, take the nearest end, black for NaN.
///   source  Green, A colour scheme for the display of astronomical intensity images (2011): cubehelix, with start 0.5,
///           -1.5 rotations, hue 1, gamma 1
Color RampColor(double number);

/// A heat picture of numbers from 0 to 1.
Image RampImage(const Plane& numbers);

}  // namespace R2
