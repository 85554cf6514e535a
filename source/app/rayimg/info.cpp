#include "source/app/report/Info.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "source/app/Status.h"
#include "source/app/files/OutputFile.h"
#include "source/app/rayimg/Commands.h"
#include "source/app/rayimg/Pictures.h"
#include "source/app/report/Messages.h"
#include "source/parse/SceneError.h"

namespace ray::rayimg {
namespace {

/// Of one channel, over its finite values.
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

}  // namespace

int Info(const Options& options, const std::string&) {
  // One bad file among many does not hide the others.
  int exit_status = status::done;
  std::string gap;
  for (const std::string& name : options.names) {
    try {
      const R2::DecodedImage picture = ReadPicture(name);
      WriteStandardOutput(
          gap + PictureText(name, {{picture.image.Width(), picture.image.Height()}, picture.format, picture.settings}) +
          StatisticsText(picture.image));
      gap = "\n";
    } catch (const SceneErrors& errors) {
      PrintError(errors.what());
      exit_status = status::bad_scene;
    }
  }
  return exit_status;
}

}  // namespace ray::rayimg
