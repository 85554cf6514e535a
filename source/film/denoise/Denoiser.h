#pragma once

#include <array>
#include <memory>
#include <string>

#include "source/film/denoise/OpenImageDenoise.h"

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

/// The filters of a denoiser, ready to work.
class DenoiseFilters {
 public:
  /// `threads` as in RenderSettings. Throws DenoiserError where a library is missing or does not work.
  explicit DenoiseFilters(Denoiser denoiser = Denoiser::regression, int threads = 0);
  /// Of a library that is there.
  DenoiseFilters(bool has_regression, std::unique_ptr<const OpenImageDenoise> library);

  bool HasRegression() const { return has_regression_; }
  /// Null where it is not among them.
  const OpenImageDenoise* Library() const { return library_.get(); }
  /// "regression", "Open Image Denoise 2.5.1", "regression and Open Image Denoise 2.5.1"
  std::string Name() const;

 private:
  const bool has_regression_;
  const std::unique_ptr<const OpenImageDenoise> library_;
};

}  // namespace ray
