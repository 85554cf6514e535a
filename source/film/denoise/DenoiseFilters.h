#pragma once

#include <memory>
#include <string>

#include "source/film/denoise/Denoiser.h"
#include "source/film/denoise/OpenImageDenoise.h"

namespace ray {

/// The loaded filters of a denoiser.
class DenoiseFilters {
 public:
  /// `threads` as in RenderSettings. Throws DenoiserError if a library is missing or does not work.
  explicit DenoiseFilters(Denoiser denoiser = Denoiser::regression, int threads = 0);
  /// Uses a library that has been loaded.
  DenoiseFilters(bool has_regression, std::unique_ptr<const OpenImageDenoise> library);

  bool HasRegression() const { return has_regression_; }
  /// The library, or null if it is not used.
  const OpenImageDenoise* Library() const { return library_.get(); }
  /// Returns "regression", "Open Image Denoise 2.5.1", or "regression and Open Image Denoise 2.5.1".
  std::string Name() const;

 private:
  const bool has_regression_;
  const std::unique_ptr<const OpenImageDenoise> library_;
};

}  // namespace ray
