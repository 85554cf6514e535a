#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "R2/ImageFile.h"
#include "source/app/options/RenderOptions.h"

namespace ray {

/// "depth,normal"; nothing when one of the words is no layer, or comes twice.
std::optional<std::vector<Layer>> ReadLayerList(const std::string& word);
std::string ShowLayerList(const std::vector<Layer>& layers);

/// The layer as channels of a file that holds several.
R2::ImageLayer ChannelsOf(Layer layer, R2::Image image);
/// The names of all layers, each with those of its channels, "N.X N.Y N.Z".
std::vector<std::pair<std::string, std::string>> ChannelsOfLayers();

/// The mode that shows nothing but the layer; there is none for the flare.
std::optional<RenderMode> ModeOf(Layer layer);

/// How a layer that is a mode is rendered beside a picture: with the same camera rays, but for depths and ids, whose means over an
/// edge would be of nothing that is there: these take one sample through the middle of each pixel and the box filter.
RenderSettings SettingsForLayer(const RenderSettings& picture, Layer layer);

}  // namespace ray
