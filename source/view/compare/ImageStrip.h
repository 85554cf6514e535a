#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "R2/Image.h"

namespace ray {

/// An image that was made, and how.
struct KeptImage {
  std::shared_ptr<const R2::Image> image;
  std::string scene;    // its file
  std::string command;  // that makes it; empty if there is none
  std::string claim;    // about its error; may be empty
  double seconds = 0;   // that it took
  double samples = 0;   // per pixel, the mean
};

/// The finished images, the last at the end; beyond a limit, the oldest are dropped.
class ImageStrip {
 public:
  static constexpr std::size_t most = 16;

  void Add(KeptImage image) {
    if (images_.size() >= most) images_.erase(images_.begin());
    images_.push_back(std::move(image));
    ++added_;
  }
  const std::vector<KeptImage>& All() const { return images_; }
  /// Returns the number of images ever added, which differs after each change.
  std::size_t Number() const { return added_; }
  /// The number of an image, from 1, which does not change when older ones are dropped.
  std::size_t NumberOf(std::size_t index) const { return added_ - images_.size() + index + 1; }

 private:
  std::vector<KeptImage> images_;
  std::size_t added_ = 0;
};

}  // namespace ray
