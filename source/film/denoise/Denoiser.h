#pragma once

#include <array>

namespace ray {

/// What filters a picture is denoised by.
///   regression  ours, which gives the same bits on every machine
///   oidn        Open Image Denoise instead
///   both        whichever has less error, pixel by pixel
///   automatic   both where this machine has Open Image Denoise, else regression
enum class Denoiser { regression, oidn, both, automatic };
inline constexpr std::array denoiser_names{"regression", "oidn", "both", "auto"};
constexpr const auto& NamesOf(Denoiser) { return denoiser_names; }

/// What `automatic` means on this machine; others stay what they are.
Denoiser Resolved(Denoiser denoiser);

/// How many columns and rows away what a denoised pixel depends on may be: noise around the pixels that pixels are
/// likened to, for choices made by errors around. So much of a picture around a part makes that part equal to the same
/// part of the whole. A library looks farther.
inline constexpr int denoise_reach = 16;
/// How far, in pixels, the best guides are read from where pixels are fitted.
inline constexpr int denoise_reach_of_best_guides = 9;

}  // namespace ray
