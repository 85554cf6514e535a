#include "source/film/denoise/DenoiseFilters.h"

namespace ray {
namespace {

std::unique_ptr<const OpenImageDenoise> LibraryFor(Denoiser denoiser, int threads) {
  if (denoiser == Denoiser::regression) return {};
  return std::make_unique<const OpenImageDenoise>(threads);
}

}  // namespace

DenoiseFilters::DenoiseFilters(Denoiser denoiser, int threads)
    : DenoiseFilters(denoiser != Denoiser::oidn, LibraryFor(Resolved(denoiser), threads)) {}

DenoiseFilters::DenoiseFilters(bool has_regression, std::unique_ptr<const OpenImageDenoise> library)
    : has_regression_(has_regression), library_(std::move(library)) {}

std::string DenoiseFilters::Name() const {
  const std::string library = library_ ? "Open Image Denoise " + library_->Version() : "";
  if (!has_regression_) return library;
  return library_ ? "regression and " + library : "regression";
}

}  // namespace ray
