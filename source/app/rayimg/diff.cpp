#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "R2/Ramp.h"
#include "R2/compare/Difference.h"
#include "R2/compare/Flip.h"
#include "source/app/Status.h"
#include "source/app/files/OutputFile.h"
#include "source/app/options/Help.h"
#include "source/app/rayimg/Commands.h"
#include "source/app/rayimg/Independence.h"
#include "source/app/rayimg/Pictures.h"
#include "source/app/report/Messages.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray::rayimg {
namespace {

constexpr const char* channel_names[] = {"r", "g", "b"};

/// Everything measured.
struct Findings {
  R2::Difference difference;
  double flip = 0;
  std::optional<double> product;              // mean (x - r1)(x - r2), with a second reference
  std::optional<std::int64_t> pixels_beyond;  // with -fail
  std::vector<std::string> failures;

  double PercentBeyond() const {
    return 100 * static_cast<double>(pixels_beyond.value_or(0)) / static_cast<double>(difference.pixels);
  }
};

/// Why the pictures differ by more than is allowed. A measure that is NaN is not within its limit.
std::vector<std::string> Failures(const Findings& found, const Options& options) {
  std::vector<std::string> failures;
  const auto limit = [&](const char* what, double value, std::optional<double> highest) {
    if (!highest) return;
    if (found.difference.pixels_not_finite > 0)
      failures.push_back(std::string(what) + " is not known where pixels are not finite");
    else if (!(value <= *highest))
      failures.push_back(std::string(what) + " " + Rounded(value) + " is above " + ToText(*highest));
  };
  const double percent_allowed = options.fail_percent.value_or(0);
  if (found.pixels_beyond && !(found.PercentBeyond() <= percent_allowed))
    failures.push_back(Rounded(found.PercentBeyond()) + " % of the pixels differ by more than " +
                       ToText(*options.fail) + ", allowed are " + ToText(percent_allowed) + " %");
  limit("linear RMSE", found.difference.rmse, options.fail_rmse);
  limit("FLIP", found.flip, options.fail_flip);
  return failures;
}

std::string Line(std::string name, const std::string& value) {
  constexpr std::size_t column_of_values = 16;
  name.resize(column_of_values, ' ');
  return name + value + "\n";
}

/// No root of a negative number: then there is less error than the noise that is left.
std::optional<double> Root(double product) {
  if (!(product >= 0)) return {};
  return std::sqrt(product);
}

std::string TextOf(const Findings& found, const Options& options) {
  const R2::Difference& d = found.difference;
  std::string text = Escaped(options.names[0]) + " against " + Escaped(options.names[1]) + "\n";
  text += Line("linear RMSE", Rounded(d.rmse)) + Line("relMSE", Rounded(d.relative_mse)) +
          Line("display RMSE", Rounded(d.display_rmse) + " / 255") + Line("PSNR", Rounded(d.psnr) + " dB") +
          Line("FLIP", Rounded(found.flip)) +
          Line("largest", Rounded(d.largest.value) + " at " + std::to_string(d.largest.x) + " " +
                              std::to_string(d.largest.y) + ", channel " + channel_names[d.largest.channel]) +
          Line("bias", "r " + Rounded(d.bias.r) + ", g " + Rounded(d.bias.g) + ", b " + Rounded(d.bias.b));
  if (found.product) {
    const auto root = Root(*found.product);
    text += Line("two references", "MSE " + Rounded(*found.product) + ", RMSE " +
                                       (root ? Rounded(*root) : "below the references' noise"));
  }
  if (d.pixels_not_finite > 0)
    text += Line("not finite", Counted(static_cast<std::uint64_t>(d.pixels_not_finite), "pixel") + ", left out above");
  if (found.pixels_beyond)
    text += Line("beyond " + ToText(*options.fail), Counted(static_cast<std::uint64_t>(*found.pixels_beyond), "pixel") +
                                                        ", " + Rounded(found.PercentBeyond()) + " %");
  for (const std::string& failure : found.failures) text += "fails: " + failure + "\n";
  return text;
}

/// A key for every line of the text. Numbers that JSON cannot hold become null.
std::string JsonOf(const Findings& found, const Options& options) {
  using Json = nlohmann::ordered_json;
  const R2::Difference& d = found.difference;
  Json json{
      {"picture", options.names[0]},
      {"reference", options.names[1]},
      {"rmse", d.rmse},
      {"relative_mse", d.relative_mse},
      {"display_rmse", d.display_rmse},
      {"psnr", d.psnr},
      {"flip", found.flip},
      {"largest",
       {{"value", d.largest.value},
        {"x", d.largest.x},
        {"y", d.largest.y},
        {"channel", channel_names[d.largest.channel]}}},
      {"bias", Json::array({d.bias.r, d.bias.g, d.bias.b})},
      {"pixels", d.pixels},
      {"pixels_not_finite", d.pixels_not_finite},
  };
  if (found.product) {
    json["reference2"] = options.reference2;
    json["two_reference_mse"] = *found.product;
    json["two_reference_rmse"] = Root(*found.product) ? Json(*Root(*found.product)) : Json();
  }
  if (found.pixels_beyond) {
    json["pixels_beyond"] = *found.pixels_beyond;
    json["percent_beyond"] = found.PercentBeyond();
  }
  json["failures"] = found.failures;
  // File names may be any bytes; JSON holds UTF-8 only.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// A reference that began with the same random numbers shares noise with the picture, which then looks better than it
/// is. With as many samples, the same picture is meant to come out, and nothing is to be said.
void WarnOfSharedNoise(const std::vector<std::string>& names, const R2::ImageSettings& x, const R2::ImageSettings& r) {
  if (Setting(x, "samples") == Setting(r, "samples")) return;
  if (const auto why = WhyDependent(names[0], x, names[1], r))
    PrintError("rayimg: warning: " + *why + "; the true error may be larger");
}

void RefuseDependent(const std::string& a_name, const R2::DecodedImage& a, const std::string& b_name,
                     const R2::DecodedImage& b) {
  if (const auto why = WhyDependent(a_name, a.settings, b_name, b.settings))
    throw UsageError("-reference2 needs a picture of its own: " + *why);
}

}  // namespace

int Diff(const Options& options, const std::string& command_line) {
  std::vector<std::string> inputs = options.names;
  if (!options.reference2.empty()) inputs.push_back(options.reference2);
  std::optional<PictureOutput> map_output;
  if (!options.map.empty()) map_output = CheckPictureOutput(options.map, inputs);

  const R2::DecodedImage picture = ReadLight(options.names[0], options.srgb);
  const R2::DecodedImage reference = ReadLight(options.names[1], options.srgb);
  const R2::Image &x = picture.image, &r = reference.image;
  RefuseOtherSize(options.names[0], x, options.names[1], r);
  WarnOfSharedNoise(options.names, picture.settings, reference.settings);

  const R2::Display display = options.srgb ? R2::Display::srgb : R2::Display::straight;
  const R2::Plane flip = R2::Flip(Displayed(x, display), Displayed(r, display), options.pixels_per_degree);
  Findings found{
      .difference = Compare(x, r, display), .flip = Mean(flip), .product = {}, .pixels_beyond = {}, .failures = {}};
  if (!options.reference2.empty()) {
    const R2::DecodedImage second = ReadLight(options.reference2, options.srgb);
    RefuseOtherSize(options.names[0], x, options.reference2, second.image);
    RefuseDependent(options.names[0], picture, options.reference2, second);
    RefuseDependent(options.names[1], reference, options.reference2, second);
    found.product = ProductMse(x, r, second.image);
  }
  if (options.fail) found.pixels_beyond = PixelsBeyond(x, r, *options.fail);
  found.failures = Failures(found, options);

  if (map_output) {
    const R2::Plane plane = options.map_of == MapOf::flip ? flip : DisplayDifference(x, r, display);
    Write(*map_output, RampImage(plane), {}, {{"program", NameAndVersion(Program::rayimg)}, {"command", command_line}});
  }
  WriteStandardOutput(options.json ? JsonOf(found, options) : TextOf(found, options));
  return found.failures.empty() ? status::done : status::failed;
}

}  // namespace ray::rayimg
