#pragma once

#include <span>
#include <string>
#include <vector>

#include "R2/ImageFile.h"

namespace ray::rayimg {

/// The name of the layer with the channels R, G and B, or luminance and chroma, which has no name in files.
inline constexpr const char* color_layer = "color";

/// Channels of a file that belong together: "N.X", "N.Y" and "N.Z" are the layer N; R, G and B are the color. Any other
/// channel without a dot is a layer by itself.
///   source   OpenEXR, Technical Introduction (2013), "Layers"
struct Layer {
  std::string name;
  std::vector<R2::ImageChannel> channels;  // red before green before blue, x before y before z, others in file order
};

std::vector<Layer> LayersOf(const R2::ImageChannels& channels);

/// Returns "N: N.X, N.Y, N.Z, float".
std::string Description(const Layer& layer);

/// Returns the names of the channels.
std::vector<std::string> ChannelNames(const Layer& layer);

/// Returns the layers of an image file other than its color; empty for formats without named channels.
std::vector<Layer> FurtherLayers(const R2::ImageFormat& format, std::span<const unsigned char> bytes);

/// Warns about the further layers of a file, which are not written.
void WarnOfFurtherLayers(const std::string& file);

}  // namespace ray::rayimg
