#pragma once

#include <optional>
#include <string>
#include <vector>

#include "R2/ImageFile.h"
#include "source/app/options/Options.h"

namespace ray {

/// "depth,normal" as the names of layers; nothing when one of them is none, or comes twice.
std::optional<std::vector<std::string>> ReadLayerList(const std::string& word);
std::string ShowLayerList(const std::vector<std::string>& layers);

/// The layer as channels of a file that holds several.
R2::ImageLayer ChannelsOf(const std::string& layer, R2::Image image);

/// "out.depth.png" for "out.png".
std::string LayerFileName(const std::string& picture, const std::string& layer);

/// How a layer is rendered beside a picture: with the same camera rays, but for depths and ids, whose means over an
/// edge would be of nothing that is there: these take one sample through the middle of each pixel and the box filter.
RenderSettings SettingsForLayer(const RenderSettings& picture, const std::string& layer);

}  // namespace ray
