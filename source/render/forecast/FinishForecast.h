#pragma once

#include <functional>

#include "R2/Image.h"
#include "source/film/Film.h"

namespace ray {

/// How long a picture takes from its last sample to the finished file: foretold by composing and encoding parts of it,
/// since that depends on what is seen.
///   accuracy   as docs/accuracy.md has it
class FinishForecast {
 public:
  ///   seconds   as far as that is known before
  ///   encode    encodes an image as it will be written; empty: nothing more is known
  FinishForecast(double seconds, std::function<void(const R2::Image&)> encode)
      : encode_(std::move(encode)), seconds_(seconds) {}

  /// At the picture as it is, whose pixels will be made bytes in this way.
  void Look(const Film& film, R2::Quantization quantization);
  double Seconds() const { return seconds_; }

 private:
  std::function<void(const R2::Image&)> encode_;
  double seconds_;
  bool has_looked_ = false;
};

}  // namespace ray
