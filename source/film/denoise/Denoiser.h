#pragma once

#include <array>

namespace ray {

/// The filters of a denoised image.
///   regression  our own, bit-identical on every machine
///   oidn        Open Image Denoise
///   both        for each pixel, whichever has less error
///   automatic   both if this machine has Open Image Denoise, otherwise regression
enum class Denoiser { regression, oidn, both, automatic };
inline constexpr std::array denoiser_names{"regression", "oidn", "both", "auto"};
constexpr const auto& NamesOf(Denoiser) { return denoiser_names; }

/// Replaces `automatic` by its meaning on this machine; returns other values unchanged.
Denoiser Resolved(Denoiser denoiser);

/// The number of columns and rows around a pixel on which its denoised value may depend: noise around the pixels that
/// are compared with others, for choices made by errors around. With this much of an image around a part, the part
/// equals the same part of the whole. A library reads farther.
inline constexpr int denoise_reach = 16;
/// The distance, in pixels, at which the best guides are read around fitted pixels.
inline constexpr int denoise_reach_of_best_guides = 9;

}  // namespace ray
