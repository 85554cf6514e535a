#include "rayimg/Layers.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "source/app/report/Info.h"
#include "source/app/report/Messages.h"
#include "source/text/EnumNames.h"
#include "source/text/Quoting.h"

namespace ray::rayimg {
namespace {

constexpr std::string_view order = "RGBXYZUVA";

bool IsOfColor(std::string_view channel) {
  constexpr std::array color{"R", "G", "B", "Y", "RY", "BY"};
  return std::ranges::find(color, channel) != color.end();
}

std::string LayerOf(const std::string& channel) {
  const std::size_t dot = channel.rfind('.');
  if (dot != std::string::npos) return channel.substr(0, dot);
  return IsOfColor(channel) ? color_layer : channel;
}

/// Returns the rank of a channel within its layer by the last part of its name.
std::size_t Rank(const R2::ImageChannel& channel) {
  const std::string_view name = channel.name;
  const std::string_view last = name.substr(name.rfind('.') + 1);
  const std::size_t place = last.size() == 1 ? order.find(last[0] & ~0x20) : std::string_view::npos;
  return std::min(place, order.size());
}

}  // namespace

std::vector<Layer> LayersOf(const R2::ImageChannels& channels) {
  std::vector<Layer> layers;
  for (const R2::ImageChannel& channel : channels.channels) {
    const std::string name = LayerOf(channel.name);
    auto layer = std::ranges::find(layers, name, &Layer::name);
    if (layer == layers.end()) layer = layers.insert(layers.end(), Layer{name, {}});
    layer->channels.push_back(channel);
  }
  for (Layer& layer : layers) std::ranges::stable_sort(layer.channels, {}, Rank);
  std::ranges::stable_partition(layers, [](const Layer& layer) { return layer.name == color_layer; });
  return layers;
}

std::vector<std::string> ChannelNames(const Layer& layer) {
  std::vector<std::string> names;
  for (const R2::ImageChannel& channel : layer.channels) names.push_back(channel.name);
  return names;
}

std::string Description(const Layer& layer) {
  std::string text = Escaped(layer.name) + ":";
  for (std::size_t i = 0; i < layer.channels.size(); ++i) {
    const R2::ImageChannel& channel = layer.channels[i];
    const bool type_changes = i + 1 == layer.channels.size() || layer.channels[i + 1].type != channel.type;
    text += " " + Escaped(channel.name) + (type_changes ? std::string(" ") + NameOf(channel.type) : "") +
            (i + 1 < layer.channels.size() ? "," : "");
  }
  return text;
}

std::vector<Layer> FurtherLayers(const R2::ImageFormat& format, std::span<const unsigned char> bytes) {
  if (!format.read_channels) return {};
  std::vector<Layer> layers = LayersOf(format.read_channels(bytes));
  std::erase_if(layers, [](const Layer& layer) { return layer.name == color_layer; });
  return layers;
}

void WarnOfFurtherLayers(const std::string& file) {
  const std::vector<unsigned char> bytes = ReadBytes(file);
  const R2::ImageHeader header = R2::ReadImageHeader(bytes);
  std::string names;
  for (const Layer& layer : FurtherLayers(*header.format, bytes))
    names += (names.empty() ? "" : ", ") + Escaped(layer.name);
  if (!names.empty())
    PrintError("rayimg: warning: " + Quoted(file) + " has further layers, which are skipped: " + names +
               "; rayimg extract writes one of them");
}

}  // namespace ray::rayimg
