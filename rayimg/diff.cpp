#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "R2/Ramp.h"
#include "rayimg/Commands.h"
#include "rayimg/Findings.h"
#include "rayimg/FolderDiff.h"
#include "rayimg/Images.h"
#include "rayimg/Independence.h"
#include "rayimg/PairTables.h"
#include "source/app/Status.h"
#include "source/app/files/OutputFile.h"
#include "source/app/manual/Manual.h"
#include "source/app/report/Messages.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray::rayimg {
namespace {

std::string Line(std::string name, const std::string& value) {
  constexpr std::size_t column_of_values = 16;
  name.resize(column_of_values, ' ');
  return name + value + "\n";
}

std::string TextOf(const Findings& found, const ImageOptions& options) {
  const R2::Difference& d = found.difference;
  std::string text = Escaped(options.names[0]) + " against " + Escaped(options.names[1]) + "\n";
  text += Line("linear RMSE", Rounded(d.rmse)) + Line("relMSE", Rounded(d.relative_mse)) +
          Line("display RMSE", Rounded(d.display_rmse) + " / 255") + Line("PSNR", Rounded(d.psnr) + " dB") +
          Line("FLIP", Rounded(found.flip)) +
          Line("largest", Rounded(d.largest.value) + " at " + std::to_string(d.largest.x) + " " +
                              std::to_string(d.largest.y) + ", channel " + ChannelName(d.largest.channel)) +
          Line("bias", "r " + Rounded(d.bias.r) + ", g " + Rounded(d.bias.g) + ", b " + Rounded(d.bias.b));
  if (found.product) {
    const auto root = Root(*found.product);
    text += Line("two references", "MSE " + Rounded(*found.product) + ", RMSE " +
                                       (root ? Rounded(*root) : "below the references' noise"));
  }
  if (d.pixels_not_finite > 0)
    text += Line("not finite", Counted(static_cast<std::uint64_t>(d.pixels_not_finite), "pixel") + ", excluded above");
  if (found.pixels_beyond)
    text += Line("beyond " + ToText(*options.fail), Counted(static_cast<std::uint64_t>(*found.pixels_beyond), "pixel") +
                                                        ", " + Rounded(found.PercentBeyond()) + "%");
  for (const std::string& failure : found.failures) text += "fails: " + failure + "\n";
  return text;
}

/// Warns if the reference started with the same random numbers: it then shares noise with the image, which looks better
/// than it is. With equal numbers of samples no warning is given, because identical images are expected.
void WarnOfSharedNoise(const std::vector<std::string>& names, const R2::ImageSettings& x, const R2::ImageSettings& r) {
  if (Setting(x, "samples") == Setting(r, "samples")) return;
  if (const auto why = WhyDependent(names[0], x, names[1], r))
    PrintError("rayimg: warning: " + *why + "; the true error may be larger");
}

void RefuseDependent(const std::string& a_name, const R2::DecodedImage& a, const std::string& b_name,
                     const R2::DecodedImage& b) {
  if (const auto why = WhyDependent(a_name, a.settings, b_name, b.settings))
    throw UsageError("-reference2 needs an image of its own: " + *why);
}

/// Returns JSON text. File names may be any bytes, but JSON must be UTF-8.
std::string JsonText(const Findings& found, const ImageOptions& options) {
  nlohmann::ordered_json json{{"picture", options.names[0]}, {"reference", options.names[1]}};
  json.update(JsonOf(found, options.reference2));
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// Returns the error without the noise of the reference.
double Product(const R2::DecodedImage& decoded, const R2::DecodedImage& reference, const ImageOptions& options) {
  const R2::DecodedImage second = ReadLight(options.reference2, options.srgb);
  RefuseOtherSize(options.names[0], decoded.image, options.reference2, second.image);
  RefuseDependent(options.names[0], decoded, options.reference2, second);
  RefuseDependent(options.names[1], reference, options.reference2, second);
  return ProductMse(decoded.image, reference.image, second.image);
}

int DiffImages(const ImageOptions& options, const std::string& command_line) {
  std::vector<std::string> inputs = options.names;
  if (!options.reference2.empty()) inputs.push_back(options.reference2);
  std::optional<ImageOutput> map_output;
  if (!options.map.empty()) map_output = CheckImageOutput(options.map, inputs);
  const PairTables tables(options, inputs);

  const R2::DecodedImage decoded = ReadLight(options.names[0], options.srgb);
  const R2::DecodedImage reference = ReadLight(options.names[1], options.srgb);
  const R2::Image &x = decoded.image, &r = reference.image;
  RefuseOtherSize(options.names[0], x, options.names[1], r);
  WarnOfSharedNoise(options.names, decoded.settings, reference.settings);

  Measurement measured = Measure(x, r, options);
  Findings& found = measured.found;
  if (!options.reference2.empty()) found.product = Product(decoded, reference, options);
  if (map_output) {
    const R2::Plane plane =
        options.map_of == MapOf::flip ? measured.flip_map : DisplayDifference(x, r, DisplayOf(options));
    Write(*map_output, RampImage(plane), {}, {{"program", NameAndVersion(Program::rayimg)}, {"command", command_line}});
  }
  if (tables.AreWanted())
    tables.Write(
        {ResultOf({options.names[0], options.names[0], options.names[1]}, decoded, reference, measured, options)});
  WriteStandardOutput(options.json ? JsonText(found, options) : TextOf(found, options));
  return found.failures.empty() ? status::done : status::failed;
}

bool IsFolder(const std::string& name) {
  std::error_code ignored;
  return std::filesystem::is_directory(name, ignored);
}

}  // namespace

int Diff(const ImageOptions& options, const std::string& command_line) {
  const bool first = IsFolder(options.names[0]), second = IsFolder(options.names[1]);
  if (first && second) return DiffFolders(options);
  if (first || second)
    throw UsageError(QuotedPath(options.names[first ? 0 : 1]) + " is a folder and " +
                     QuotedPath(options.names[first ? 1 : 0]) + " is not; diff compares two images or two folders");
  return DiffImages(options, command_line);
}

}  // namespace ray::rayimg
