#include "source/view/compare/ImageStrip.h"

#include <utility>

namespace ray {

void ImageStrip::Add(KeptImage image) {
  if (images_.size() >= most) images_.erase(images_.begin());
  images_.push_back(std::move(image));
  ++added_;
}

}  // namespace ray
