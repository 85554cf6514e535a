#pragma once

namespace ray {

/// One of `of` parts of an image that several machines render together. Each block of the film belongs to one part, see
/// PartsOfBlocks.
struct ImagePart {
  int index = 1, of = 1;  // 1-based, index <= of
  friend bool operator==(const ImagePart&, const ImagePart&) = default;
};
inline constexpr int most_image_parts = 1 << 20;

}  // namespace ray
