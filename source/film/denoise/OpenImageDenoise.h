#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "source/film/denoise/Guides.h"
#include "source/film/denoise/Pixels.h"

namespace ray {

/// The reason why an image cannot be denoised: a library that is missing, too old or has failed.
struct DenoiserError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Intel Open Image Denoise, versions 1.4 and later, on the CPU: a neural network trained on path traced images. The
/// library is loaded at its first use, so that programs run without it: that of the system, otherwise that of the
/// Python package pyoidn. Its results are bit-identical for any number of threads, but may differ on another machine or
/// in another version.
///   source   Open Image Denoise API reference (openimagedenoise.org/documentation.html), filter RT
class OpenImageDenoise {
 public:
  /// A function that returns the library's function of that name; null if there is none.
  using FindFunction = std::function<void*(const char* name)>;

  /// Loads this machine's library; `threads` as in RenderSettings. Throws DenoiserError if it is missing.
  explicit OpenImageDenoise(int threads);
  /// Uses the library whose functions `find` returns.
  OpenImageDenoise(const FindFunction& find, int threads);
  ~OpenImageDenoise();

  /// Returns true if this machine has the library, in a version that works.
  static bool IsPresent();

  /// Returns a version such as "2.5.1".
  std::string Version() const;

  /// Returns the colors without noise, guided by albedos and normals that are almost noise-free. Throws DenoiserError.
  Pixels<Rgb> Filtered(const Pixels<Rgb>& colors, const Pixels<PixelGuide>& guides) const;

 private:
  struct Functions;
  class Filter;

  void ThrowIfFailed() const;

  const std::unique_ptr<const Functions> functions_;
  const std::unique_ptr<void, void (*)(void*)> device_;
};

}  // namespace ray
