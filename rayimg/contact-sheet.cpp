#include <algorithm>
#include <cmath>
#include <filesystem>

#include "rayimg/Commands.h"
#include "rayimg/ImageFolder.h"
#include "rayimg/Images.h"
#include "rayimg/Sheet.h"
#include "source/app/Status.h"
#include "source/app/manual/Manual.h"
#include "source/app/report/Messages.h"
#include "source/film/Resize.h"
#include "source/parse/SceneError.h"

namespace ray::rayimg {
namespace {

constexpr int usual_width = 160;

/// Returns the named images, and those of folders except the sheet itself, which an earlier run may have left there.
std::vector<std::string> ImagesOf(const std::vector<std::string>& names, const std::string& sheet) {
  std::vector<std::string> images;
  for (const std::string& name : names) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(name, ignored)) {
      images.push_back(name);
      continue;
    }
    for (const std::string& image : ImagesIn(name))
      if (!std::filesystem::equivalent(image, sheet, ignored)) images.push_back(image);
  }
  return images;
}

/// Returns a cross, for files that cannot be read.
R2::Image Cross(int side) {
  R2::Image cross(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      cross.Set(x, y, x == y || x == side - 1 - y ? R2::Color{0.7, 0, 0} : R2::Color{0.9, 0.9, 0.9});
  return cross;
}

/// Returns the image as displayed, scaled to fit into a square with that side.
R2::Image Thumbnail(const std::string& name, const ImageOptions& options, int side) {
  R2::Image image = ReadLight(name, options.srgb).image;
  Expose(image, options);
  const double scale =
      std::min({1.0, static_cast<double>(side) / image.Width(), static_cast<double>(side) / image.Height()});
  const auto scaled = [&](int length) { return std::max(1, static_cast<int>(std::lround(scale * length))); };
  return Padded(Resized(image, scaled(image.Width()), scaled(image.Height()), FilterKind::box), side, side);
}

}  // namespace

int ContactSheet(const ImageOptions& options, const std::string& command_line) {
  const std::vector<std::string> names = ImagesOf(options.names, options.out);
  const ImageOutput output = CheckImageOutput(options.out, names);
  if (names.empty()) throw UsageError("there is no image but the sheet itself");
  const int side = options.width.value_or(usual_width);
  int exit_status = status::done;
  std::vector<Tile> tiles;
  for (const std::string& name : names) {
    tiles.push_back({{}, std::filesystem::path(name).filename().string()});
    try {
      tiles.back().image = Thumbnail(name, options, side);
    } catch (const SceneErrors& errors) {
      PrintError(errors.what());
      tiles.back().image = Cross(side);
      exit_status = status::bad_scene;
    }
  }
  const auto square = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(names.size()))));
  const int gap = options.gap.value_or(8);
  Write(output,
        Arranged(tiles, {options.columns ? static_cast<std::size_t>(*options.columns) : square, gap, gap, true}),
        EncodingOf(options, output), {{"program", NameAndVersion(Program::rayimg)}, {"command", command_line}});
  return exit_status;
}

}  // namespace ray::rayimg
