#include "rayimg/Findings.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "R2/compare/Flip.h"
#include "rayimg/Images.h"
#include "source/text/NumberText.h"

namespace ray::rayimg {
namespace {

/// Returns why the images differ by more than allowed. A measure that is NaN is not within its limit.
std::vector<std::string> Failures(const Findings& found, const ImageOptions& options) {
  std::vector<std::string> failures;
  const auto limit = [&](const char* what, double value, std::optional<double> highest) {
    if (!highest) return;
    if (found.difference.pixels_not_finite > 0)
      failures.push_back(std::string(what) + " is unknown because pixels are not finite");
    else if (!(value <= *highest))
      failures.push_back(std::string(what) + " " + Rounded(value) + " is above " + ToText(*highest));
  };
  const double percent_allowed = options.fail_percent.value_or(0);
  if (found.pixels_beyond && !(found.PercentBeyond() <= percent_allowed))
    failures.push_back(Rounded(found.PercentBeyond()) + "% of the pixels differ by more than " + ToText(*options.fail) +
                       ", allowed are " + ToText(percent_allowed) + "%");
  limit("linear RMSE", found.difference.rmse, options.fail_rmse);
  limit("FLIP", found.flip, options.fail_flip);
  return failures;
}

}  // namespace

R2::Display DisplayOf(const ImageOptions& options) { return options.srgb ? R2::Display::srgb : R2::Display::straight; }

Measurement Measure(const R2::Image& x, const R2::Image& r, const ImageOptions& options) {
  const R2::Display display = DisplayOf(options);
  R2::Plane flip = R2::Flip(Displayed(x, display), Displayed(r, display), options.pixels_per_degree);
  Findings found{
      .difference = Compare(x, r, display), .flip = Mean(flip), .product = {}, .pixels_beyond = {}, .failures = {}};
  if (options.fail) found.pixels_beyond = PixelsBeyond(x, r, *options.fail);
  found.failures = Failures(found, options);
  return {std::move(found), std::move(flip)};
}

const char* ChannelName(int channel) {
  constexpr const char* names[] = {"r", "g", "b"};
  return names[channel];
}

std::optional<double> Root(double product) {
  if (!(product >= 0)) return {};
  return std::sqrt(product);
}

nlohmann::ordered_json JsonOf(const Findings& found, const std::string& reference2) {
  using Json = nlohmann::ordered_json;
  const R2::Difference& d = found.difference;
  Json json{
      {"rmse", d.rmse},
      {"relative_mse", d.relative_mse},
      {"display_rmse", d.display_rmse},
      {"psnr", d.psnr},
      {"flip", found.flip},
      {"largest",
       {{"value", d.largest.value},
        {"x", d.largest.x},
        {"y", d.largest.y},
        {"channel", ChannelName(d.largest.channel)}}},
      {"bias", Json::array({d.bias.r, d.bias.g, d.bias.b})},
      {"pixels", d.pixels},
      {"pixels_not_finite", d.pixels_not_finite},
  };
  if (found.product) {
    json["reference2"] = reference2;
    json["two_reference_mse"] = *found.product;
    json["two_reference_rmse"] = Root(*found.product) ? Json(*Root(*found.product)) : Json();
  }
  if (found.pixels_beyond) {
    json["pixels_beyond"] = *found.pixels_beyond;
    json["percent_beyond"] = found.PercentBeyond();
  }
  json["failures"] = found.failures;
  return json;
}

}  // namespace ray::rayimg
