#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "R2/ImageFile.h"
#include "source/app/options/RenderOptions.h"

namespace ray {

/// Parses "depth,normal"; std::nullopt if one of the words is not a layer, or is repeated.
std::optional<std::vector<Layer>> ReadLayerList(const std::string& word);
std::string ShowLayerList(const std::vector<Layer>& layers);

/// Returns the layer as channels of a multi-channel file.
R2::ImageLayer ChannelsOf(Layer layer, R2::Image image);
/// Returns the names of all layers, each with those of its channels, "N.X N.Y N.Z".
std::vector<std::pair<std::string, std::string>> ChannelsOfLayers();

/// Returns the mode that shows only the layer; there is none for the flare.
std::optional<RenderMode> ModeOf(Layer layer);

/// Returns the settings for rendering a mode as a layer of an image: with the same camera rays, except for depths and
/// ids, whose means across an edge would be meaningless: these take one sample through the center of each pixel and the
/// box filter.
RenderSettings SettingsForLayer(const RenderSettings& image, Layer layer);

}  // namespace ray
