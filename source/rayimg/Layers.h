#pragma once

#include <span>
#include <string>
#include <vector>

#include "R2/ImageFile.h"

namespace ray::rayimg {

/// The name of the layer of the channels R, G and B, or of those of luminance and chroma, which the files do not name.
inline constexpr const char* color_layer = "color";

/// Channels of a file that belong together: "N.X", "N.Y" and "N.Z" are the layer N; R, G and B are the color. Another
/// channel without a dot is a layer by itself.
///   source   OpenEXR, Technical Introduction (2013), "Layers"
struct Layer {
  std::string name;
  std::vector<R2::ImageChannel> channels;  // red before green before blue, x before y before z, others as in the file
};

std::vector<Layer> LayersOf(const R2::ImageChannels& channels);

/// "N: N.X, N.Y, N.Z, float"
std::string Description(const Layer& layer);

/// Names of the channels.
std::vector<std::string> ChannelNames(const Layer& layer);

/// What a picture's file holds beside its color; none for formats whose channels have no names.
std::vector<Layer> FurtherLayers(const R2::ImageFormat& format, std::span<const unsigned char> bytes);

/// Prints a warning that names the further layers of a file, of which nothing is written.
void WarnOfLayersLeftOut(const std::string& file);

}  // namespace ray::rayimg
