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

}  // namespace ray
