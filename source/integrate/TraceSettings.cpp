#include "source/integrate/TraceSettings.h"

#include <algorithm>

namespace ray {

SamplerKind SamplerNamed(const std::string& name) {
  const auto found = std::find(sampler_names.begin(), sampler_names.end(), name);
  return static_cast<SamplerKind>(found - sampler_names.begin());
}

}  // namespace ray
