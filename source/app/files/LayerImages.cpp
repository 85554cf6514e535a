#include "source/app/files/LayerImages.h"

#include <algorithm>

#include "source/text/EnumNames.h"

namespace ray {

std::optional<std::vector<Layer>> ReadLayerList(const std::string& word) {
  std::vector<Layer> layers;
  for (std::size_t begin = 0; begin <= word.size();) {
    const std::size_t end = std::min(word.find(',', begin), word.size());
    const auto layer = Named<Layer>(word.substr(begin, end - begin));
    if (!layer || std::find(layers.begin(), layers.end(), *layer) != layers.end()) return {};
    layers.push_back(*layer);
    begin = end + 1;
  }
  return layers;
}

std::string ShowLayerList(const std::vector<Layer>& layers) {
  std::string text;
  for (const Layer layer : layers) text += std::string(text.empty() ? "" : ",") + NameOf(layer);
  return text;
}

R2::ImageLayer ChannelsOf(Layer layer, R2::Image image) {
  switch (layer) {
    case Layer::depth:
      return {{"Z"}, std::move(image)};
    case Layer::normal:
      return {{"N.X", "N.Y", "N.Z"}, std::move(image)};
    case Layer::uv:
      return {{"uv.U", "uv.V"}, std::move(image)};
    case Layer::albedo:
      return {{"albedo.R", "albedo.G", "albedo.B"}, std::move(image)};
    case Layer::id:
      return {{"id"}, std::move(image)};
    case Layer::flare:
      return {{"flare.R", "flare.G", "flare.B"}, std::move(image)};
  }
  return {};
}

std::vector<std::pair<std::string, std::string>> ChannelsOfLayers() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const char* name : layer_names) {
    std::string channels;
    for (const std::string& channel : ChannelsOf(*Named<Layer>(name), {}).channels)
      channels += (channels.empty() ? "" : " ") + channel;
    all.emplace_back(name, channels);
  }
  return all;
}

std::optional<RenderMode> ModeOf(Layer layer) { return Named<RenderMode>(NameOf(layer)); }

RenderSettings SettingsForLayer(const RenderSettings& image, Layer layer) {
  RenderSettings settings = image;
  settings.mode = *ModeOf(layer);
  settings.budget = {};
  settings.replay.reset();
  settings.wants_passes = false;
  settings.denoise = settings.shares_light = false;
  settings.places = BlockOrder::places;  // interpolated normals and texture coordinates would be wrong
  if (layer == Layer::id || layer == Layer::depth) {
    settings.samples = 1;
    settings.filter = FilterKind::box;
  }
  return settings;
}

}  // namespace ray
