#include "source/parse/courses/objects/Gloss.h"

namespace ray {

void ReadGloss(Mapping& material, Mapping::Names exponent, Mapping::Names samples, Material& read) {
  const auto gloss = material.Find(exponent), rays = material.Find(samples);
  if (rays && !gloss) return rays->Error("goes with " + std::string(*exponent.begin()) + ", which is missing");
  if (!gloss) return;
  read.gloss = gloss->Number(positive).value_or(0);
  if (rays) read.gloss_samples = static_cast<int>(rays->Whole(1, Material::most_gloss_samples).value_or(1));
}

}  // namespace ray
