#include "source/view/compare/ReferenceImage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ray {
namespace {

constexpr int levels_of_bytes = 255, levels_of_shorts = 65'535;

template <typename Change>
R2::Image Changed(const R2::Image& image, const Change& change) {
  R2::Image changed(image.Width(), image.Height());
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) changed.Set(x, y, change(image.At(x, y)));
  return changed;
}

bool IsOfBytes(const R2::Image& image) {
  constexpr double rounding = 1e-3;  // of a level: floats hold the values to 2e-5 of one
  return std::ranges::all_of(image.Channels(), [](float c) {
    const double level = levels_of_bytes * static_cast<double>(c);
    return std::abs(level - std::round(level)) < rounding;
  });
}

}  // namespace

std::shared_ptr<const R2::Image> ReferenceImage::AsLight(const ByteEncoding& encoding) const {
  if (!image || IsLight() || !encoding.srgb) return image;
  return std::make_shared<const R2::Image>(Changed(*image, [](const R2::Color& c) { return R2::DecodeSrgb(c); }));
}

R2::Image ReferenceImage::Comparable(const R2::Image& light, const ByteEncoding& encoding) const {
  if (IsLight()) return light;
  const double most = levels;
  const auto level = [&](double channel) {
    return R2::Quantized<unsigned short>(channel, most, encoding.quantization) / most;
  };
  return Changed(light, [&](const R2::Color& c) {
    const R2::Color shown = encoding.srgb ? R2::EncodeSrgb(R2::Clamped(c)) : c;
    return R2::Color{level(shown.r), level(shown.g), level(shown.b)};
  });
}

ReferenceImage ReferenceOf(R2::DecodedImage decoded) {
  ReferenceImage reference{std::make_shared<const R2::Image>(std::move(decoded.image))};
  if (decoded.format->is_linear) return reference;
  reference.levels = IsOfBytes(*reference.image) ? levels_of_bytes : levels_of_shorts;
  return reference;
}

}  // namespace ray
