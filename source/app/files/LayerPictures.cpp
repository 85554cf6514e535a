#include "source/app/files/LayerPictures.h"

#include <algorithm>
#include <filesystem>

#include "source/integrate/FirstHit.h"

namespace ray {
namespace {

bool IsLayer(const std::string& name) {
  return std::find(layer_names.begin(), layer_names.end(), name) != layer_names.end();
}

}  // namespace

std::optional<std::vector<std::string>> ReadLayerList(const std::string& word) {
  std::vector<std::string> layers;
  for (std::size_t begin = 0; begin <= word.size();) {
    const std::size_t end = std::min(word.find(',', begin), word.size());
    const std::string name = word.substr(begin, end - begin);
    if (!IsLayer(name) || std::find(layers.begin(), layers.end(), name) != layers.end()) return {};
    layers.push_back(name);
    begin = end + 1;
  }
  return layers;
}

std::string ShowLayerList(const std::vector<std::string>& layers) {
  std::string text;
  for (const std::string& layer : layers) text += (text.empty() ? "" : ",") + layer;
  return text;
}

R2::ImageLayer ChannelsOf(const std::string& layer, R2::Image image) {
  if (layer == "depth") return {{"Z"}, std::move(image)};
  if (layer == "normal") return {{"N.X", "N.Y", "N.Z"}, std::move(image)};
  if (layer == "uv") return {{"uv.U", "uv.V"}, std::move(image)};
  if (layer == "id") return {{"id"}, std::move(image)};
  return {{layer + ".R", layer + ".G", layer + ".B"}, std::move(image)};
}

std::string LayerFileName(const std::string& picture, const std::string& layer) {
  const std::filesystem::path path(picture);
  return (path.parent_path() / (path.stem().string() + "." + layer + path.extension().string())).string();
}

RenderSettings SettingsForLayer(const RenderSettings& picture, const std::string& layer) {
  RenderSettings settings = picture;
  settings.mode = layer;
  settings.budget = {};
  settings.replay.reset();
  settings.wants_passes = false;
  if (layer == "id" || layer == "depth") {
    settings.samples = 1;
    settings.filter = "box";
  }
  return settings;
}

}  // namespace ray
