#include "grader/Mistake.h"

#include "grader/Changes.h"
#include "grader/mistakes/Tables.h"

namespace ray::grade {

std::span<const Mistake* const> Mistakes() {
  static const std::vector<const Mistake*> mistakes = [] {
    std::vector<const Mistake*> all;
    for (const MistakeTable* table : {&shading_mistakes, &lights_mistakes, &rays_mistakes, &geometry_mistakes,
                                      &camera_mistakes, &left_out_mistakes, &image_mistakes})
      for (const Mistake& mistake : *table) all.push_back(&mistake);
    return all;
  }();
  return mistakes;
}

Scene& Variant::OwnScene() {
  if (!own_) own_ = Copied(original_);
  return *own_;
}

}  // namespace ray::grade
