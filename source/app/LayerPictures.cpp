#include "source/app/LayerPictures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "source/integrate/FirstHit.h"
#include "source/integrate/Random.h"

namespace ray {
namespace {

bool IsLayer(const std::string& name) {
  return std::find(layer_names.begin(), layer_names.end(), name) != layer_names.end();
}

template <typename Change>
R2::Image Changed(R2::Image image, const Change& change) {
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) image.Set(x, y, change(image.At(x, y)));
  return image;
}

R2::Image ShownDepth(const R2::Image& image) {
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (const float d : image.Channels())
    if (d > 0) nearest = std::min<double>(nearest, d), farthest = std::max<double>(farthest, d);
  return Changed(image, [&](const R2::Color& c) {
    if (!(c.r > 0)) return R2::Color{};
    constexpr double dimmest = 0.1;  // the farthest, so that it differs from nothing at all
    const double share = farthest > nearest ? (c.r - nearest) / (farthest - nearest) : 0;
    const double shown = 1 - (1 - dimmest) * share;
    return R2::Color{shown, shown, shown};
  });
}

R2::Color ColorOfId(const R2::Color& id) {
  if (id.r < 0) return {};
  const RandomKey key(static_cast<std::uint64_t>(id.r));
  constexpr double dimmest = 0.2;
  const auto channel = [&](std::uint64_t k) { return dimmest + (1 - dimmest) * key.Child(k).Number(); };
  return {channel(0), channel(1), channel(2)};
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

R2::Image Shown(const std::string& layer, const R2::Image& image) {
  if (layer == "depth") return ShownDepth(image);
  if (layer == "id") return Changed(image, ColorOfId);
  if (layer == "normal")
    return Changed(image, [](const R2::Color& n) { return R2::Color{(n.r + 1) / 2, (n.g + 1) / 2, (n.b + 1) / 2}; });
  return image;
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
