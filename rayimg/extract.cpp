#include <algorithm>
#include <array>
#include <utility>

#include "rayimg/Commands.h"
#include "rayimg/Images.h"
#include "rayimg/Layers.h"
#include "source/app/Status.h"
#include "source/app/report/Info.h"
#include "source/app/report/Messages.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"
#include "source/text/LowerCase.h"
#include "source/text/Quoting.h"
#include "source/text/Words.h"

namespace ray::rayimg {
namespace {

/// Returns "; did you mean 'N'?" for raypro's layer name normal, and for similar names.
std::string Hint(const std::string& name, const std::vector<std::string>& names) {
  constexpr std::array<std::pair<const char*, const char*>, 5> other_words{
      {{"normal", "N"}, {"normals", "N"}, {"depth", "Z"}, {"z", "Z"}, {"alpha", "A"}}};
  for (const auto& [word, layer] : other_words)
    if (LowerCase(name) == word && std::ranges::find(names, layer) != names.end())
      return "; did you mean " + Quoted(layer) + "?";
  return DidYouMean(name, names);
}

[[noreturn]] void RefuseLayer(const std::string& file, const std::string& name, const std::vector<Layer>& layers) {
  std::vector<std::string> names;
  std::string list;
  for (const Layer& layer : layers) {
    names.push_back(layer.name);
    list += (list.empty() ? "" : ", ") + Escaped(layer.name);
  }
  throw UsageError(Quoted(file) + " has no layer " + Quoted(name) + Hint(name, names) + " (its layers: " + list + ")");
}

/// Finds a layer by its name, or a single channel by its whole name.
Layer Find(const std::string& file, const std::string& name, const std::vector<Layer>& layers) {
  const auto layer = std::ranges::find(layers, name, &Layer::name);
  if (layer != layers.end()) return *layer;
  for (const Layer& one : layers)
    for (const R2::ImageChannel& channel : one.channels)
      if (channel.name == name) return {name, {channel}};
  RefuseLayer(file, name, layers);
}

/// Returns the first three channels, as many as an image has.
std::vector<std::string> FirstThree(const std::string& file, const Layer& layer) {
  constexpr std::size_t most = 3;
  std::vector<std::string> names = ChannelNames(layer);
  for (std::size_t i = most; i < names.size(); ++i)
    PrintError("rayimg: warning: " + Quoted(file) + ": channel " + Quoted(names[i]) +
               " is skipped; extract it by its name");
  names.resize(std::min(most, names.size()));
  return names;
}

R2::DecodedImage DecodeLayer(const std::string& file, const Layer& layer, const R2::ImageFormat& format,
                             std::span<const unsigned char> bytes) {
  // Luminance and chroma must be converted to colors first.
  const bool is_color = layer.name == color_layer && layer.channels.size() > 1;
  if (is_color) return DecodeImageFile(file, bytes);
  R2::DecodedImage decoded = format.decode_channels(bytes, FirstThree(file, layer));
  decoded.format = &format;
  return decoded;
}

}  // namespace

int Extract(const ImageOptions& options, const std::string& command_line) {
  const std::string &in = options.names[0], &name = options.names[1];
  const std::string inputs[] = {in};
  const ImageOutput output = CheckImageOutput(options.names[2], inputs);
  const std::vector<unsigned char> bytes = ReadBytes(in);
  try {
    const R2::ImageFormat& format = *R2::ReadImageHeader(bytes).format;
    if (!format.read_channels)
      throw UsageError(Quoted(in) + " is a " + format.name + ", which has no layers; those of EXR have names");
    const Layer layer = Find(in, name, LayersOf(format.read_channels(bytes)));
    RefuseToRound(in, true, output);
    R2::DecodedImage decoded = DecodeLayer(in, layer, format, bytes);
    PrintWarnings(in, decoded.warnings);
    AddCommand(decoded.settings, command_line);
    Write(output, decoded.image, {}, decoded.settings);
  } catch (const R2::ImageError& error) {
    throw SceneErrors({ErrorIn(in, error.what())});
  }
  return status::done;
}

}  // namespace ray::rayimg
