#include "source/app/report/Info.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "rayimg/Commands.h"
#include "rayimg/Images.h"
#include "rayimg/Layers.h"
#include "source/app/Status.h"
#include "source/app/files/OutputFile.h"
#include "source/app/report/Messages.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"

namespace ray::rayimg {
namespace {

/// Statistics of one channel, over its finite values.
struct Statistics {
  double min = std::numeric_limits<double>::infinity(), max = -min, sum = 0;
  std::int64_t finite = 0, not_finite = 0, negative = 0;

  void Add(double value) {
    if (!std::isfinite(value)) {
      ++not_finite;
      return;
    }
    ++finite;
    negative += value < 0;
    min = std::min(min, value);
    max = std::max(max, value);
    sum += value;
  }
  double Mean() const { return sum / static_cast<double>(finite); }
  std::string Text() const {
    if (finite == 0) return "no finite value\n";
    return "min " + Rounded(min) + ", mean " + Rounded(Mean()) + ", max " + Rounded(max) + "\n";
  }
};

std::string StatisticsText(const R2::Image& image) {
  std::array<Statistics, 3> channels;
  const R2::Image::Floats& values = image.Channels();
  for (std::size_t i = 0; i < values.size(); ++i) channels[i % 3].Add(values[i]);
  const auto& [r, g, b] = channels;
  return "r: " + r.Text() + "g: " + g.Text() + "b: " + b.Text() +
         "mean luminance: " + Rounded(R2::Luminance({r.Mean(), g.Mean(), b.Mean()})) + "\n" +
         "values not finite: " + std::to_string(r.not_finite + g.not_finite + b.not_finite) + "\n" +
         "values negative: " + std::to_string(r.negative + g.negative + b.negative) + "\n";
}

std::string Text(const char* what, const R2::ImageWindow& window) {
  const auto corner = [](std::int64_t x, std::int64_t y) { return std::to_string(x) + " " + std::to_string(y); };
  return std::string(what) + ": " + corner(window.x0, window.y0) + " to " + corner(window.x1, window.y1) + "\n";
}

std::string LayersText(const R2::ImageChannels& channels) {
  std::string text = Text("display window", channels.display) + Text("data window", channels.data);
  for (const Layer& layer : LayersOf(channels)) text += "layer " + Description(layer) + "\n";
  return text;
}

/// Returns size, format, metadata, layers, and statistics of the color, which a file may lack.
std::string TextOf(const std::string& name) {
  const std::vector<unsigned char> bytes = ReadBytes(name);
  try {
    const R2::ImageHeader header = R2::ReadImageHeader(bytes);
    std::string text = ImageText(name, header);
    if (header.format->read_channels) {
      const R2::ImageChannels channels = header.format->read_channels(bytes);
      text += LayersText(channels);
      const auto layers = LayersOf(channels);
      if (std::ranges::find(layers, color_layer, &Layer::name) == layers.end())
        return text + "no color: rayimg extract takes a layer\n";
    }
    const R2::DecodedImage decoded = DecodeImageFile(name, bytes);
    PrintWarnings(name, decoded.warnings);
    return text + StatisticsText(decoded.image);
  } catch (const R2::ImageError& error) {
    throw SceneErrors({ErrorIn(name, error.what())});
  }
}

}  // namespace

int Info(const ImageOptions& options, const std::string&) {
  // One bad file does not stop the others.
  int exit_status = status::done;
  std::string gap;
  for (const std::string& name : options.names) {
    try {
      WriteStandardOutput(gap + TextOf(name));
      gap = "\n";
    } catch (const SceneErrors& errors) {
      PrintError(errors.what());
      exit_status = status::bad_scene;
    }
  }
  return exit_status;
}

}  // namespace ray::rayimg
