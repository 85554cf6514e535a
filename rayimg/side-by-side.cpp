#include <filesystem>

#include "rayimg/Commands.h"
#include "rayimg/Images.h"
#include "rayimg/Layers.h"
#include "rayimg/Sheet.h"
#include "source/app/Status.h"
#include "source/app/manual/Manual.h"
#include "source/text/Quoting.h"

namespace ray::rayimg {
namespace {

/// Returns the number of images in a row.
std::size_t Columns(const ImageOptions& options) {
  return options.columns ? static_cast<std::size_t>(*options.columns) : options.names.size();
}

void RefuseOtherHeight(const ImageOptions& options, const std::vector<Tile>& tiles) {
  const std::size_t first = (tiles.size() - 1) / Columns(options) * Columns(options), last = tiles.size() - 1;
  const int a = tiles[first].image.Height(), b = tiles[last].image.Height();
  if (a == b) return;
  throw UsageError("images of a row must have one height, but " + Quoted(options.names[first]) + " has " +
                   std::to_string(a) + " rows of pixels and " + Quoted(options.names[last]) + " " + std::to_string(b) +
                   "; rayimg resize -height " + std::to_string(a) + " changes that");
}

std::string CaptionOf(const ImageOptions& options, std::size_t i) {
  if (!options.captions.empty()) return options.captions[i];
  return options.captions_are_names ? std::filesystem::path(options.names[i]).filename().string() : "";
}

}  // namespace

int SideBySide(const ImageOptions& options, const std::string& command_line) {
  const ImageOutput output = CheckImageOutput(options.out, options.names);
  std::vector<Tile> tiles;
  for (std::size_t i = 0; i < options.names.size(); ++i) {
    const std::string& name = options.names[i];
    R2::DecodedImage decoded = ReadLight(name, options.srgb);
    RefuseToRound(name, decoded.format->is_linear, output);
    WarnOfFurtherLayers(name);
    tiles.push_back({std::move(decoded.image), CaptionOf(options, i)});
    RefuseOtherHeight(options, tiles);
  }
  const SheetLayout layout{.columns = Columns(options),
                           .gap = options.gap.value_or(0),
                           .has_captions = options.captions_are_names || !options.captions.empty()};
  Write(output, Arranged(tiles, layout), EncodingOf(options, output),
        {{"program", NameAndVersion(Program::rayimg)}, {"command", command_line}});
  return status::done;
}

}  // namespace ray::rayimg
