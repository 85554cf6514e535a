#pragma once

#include "R2/Image.h"
#include "R2/Plane.h"

namespace R2 {

/// The number of pixels per degree of visual angle: 67.02 for a screen 0.7 m wide with 3840 pixels viewed from 0.7 m.
inline constexpr double flip_pixels_per_degree = 67.0206;

/// Returns the perceived difference of two images for each pixel, when one alternates with the other: 0 is equal, 1 the
/// maximum. Symmetric in its images.
///   a, b              of the same size (asserted); values for a screen, sRGB-encoded, clamped to [0, 1] here; NaN is
///                     black
///   pixels_per_degree 1 to 1000: the larger, the farther away the eye and the less fine noise it sees
///   accuracy          within 2e-4 of the authors' program at each pixel, 1e-5 in the mean (tests/R2/compare/Flip.cpp)
///   source            Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild, FLIP: A Difference Evaluator
///                     for Alternating Images (2020); sections and symbols in Flip.cpp are theirs
Plane Flip(const Image& a, const Image& b, double pixels_per_degree = flip_pixels_per_degree);

}  // namespace R2
