#include "source/film/denoise/DenoisedError.h"

#include <cassert>

namespace ray {
namespace {

/// What the two streams say of a pixel's squared error, the mean of its channels.
struct PixelClaim {
  double variance = 0, squared_bias = 0;
};

/// With A, B the streams and F, G what filters made of them, as they are seen.
PixelClaim ClaimOf(double A, double B, double F, double G, double mean) {
  PixelClaim claim;
  // What is seen of the mean is not the mean of what is seen, where values are clipped.
  const double clipped = (F + G) / 2 - mean;
  claim.variance = (F - G) * (F - G) / 4 + clipped * clipped;
  claim.squared_bias = ((F - B) * (F - B) + (G - A) * (G - A) - (A - B) * (A - B) - (F - G) * (F - G)) / 2;
  return claim;
}

class Claims {
 public:
  Claims(const Film& film, const DenoisedPicture& denoised, const ErrorMeasure& measure)
      : picture_(denoised.Mean()), measure_(measure) {
    const R2::Image a = film.Part(0), b = film.Part(1);
    for (int y = 0; y < picture_.Height(); ++y)
      for (int x = 0; x < picture_.Width(); ++x)
        Add(a.At(x, y), b.At(x, y), denoised.of_stream[0].At(x, y), denoised.of_stream[1].At(x, y), picture_.At(x, y));
  }

  MeasuredError Summary(const Film& film) const {
    double variance = 0, noise = 0;  // of all pixels; of the sum of their squared biases, its variance
    for (const PixelClaim& pixel : pixels_) {
      variance += pixel.variance;
      noise += pixel.squared_bias * pixel.squared_bias;
    }
    // The mean of two guesses of the squared bias, weighted by the inverses of their variances: what was measured, and
    // as much as the variance, give or take as much.
    const double spread = variance * variance;
    const double trust = spread > 0 ? spread / (spread + noise) : 1;
    std::vector<float> squares;
    for (const PixelClaim& pixel : pixels_)
      squares.push_back(static_cast<float>(pixel.variance + trust * pixel.squared_bias + (1 - trust) * pixel.variance));
    return SummarizeErrors(film, squares, picture_, measure_);
  }

 private:
  void Add(const R2::Color& a, const R2::Color& b, const R2::Color& f, const R2::Color& g, const R2::Color& mean) {
    PixelClaim sum;
    const auto add = [&](double R2::Color::*k) {
      const PixelClaim claim =
          ClaimOf(AsMeasured(a.*k, measure_), AsMeasured(b.*k, measure_), AsMeasured(f.*k, measure_),
                  AsMeasured(g.*k, measure_), AsMeasured(mean.*k, measure_));
      sum.variance += claim.variance / 3;
      sum.squared_bias += claim.squared_bias / 3;
    };
    add(&R2::Color::r), add(&R2::Color::g), add(&R2::Color::b);
    pixels_.push_back(sum);
  }

  const R2::Image picture_;
  const ErrorMeasure measure_;
  std::vector<PixelClaim> pixels_;
};

}  // namespace

MeasuredError MeasureDenoisedError(const Film& film, const DenoisedPicture& denoised, const ErrorMeasure& measure) {
  assert(film.HasBothParts());
  return Claims(film, denoised, measure).Summary(film);
}

}  // namespace ray
