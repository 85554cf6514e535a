#include "source/film/denoise/DenoiseFilters.h"

namespace ray {

DenoiseFilters::DenoiseFilters(Denoiser denoiser, int threads)
    : DenoiseFilters(Resolved(denoiser) != Denoiser::oidn, Resolved(denoiser) != Denoiser::regression
                                                               ? std::make_unique<OpenImageDenoise>(threads)
                                                               : nullptr) {}

DenoiseFilters::DenoiseFilters(bool has_regression, std::unique_ptr<const OpenImageDenoise> library)
    : has_regression_(has_regression), library_(std::move(library)) {}

std::string DenoiseFilters::Name() const {
  const std::string library = library_ ? "Open Image Denoise " + library_->Version() : "";
  if (!has_regression_) return library;
  return library_ ? "regression and " + library : "regression";
}

}  // namespace ray
