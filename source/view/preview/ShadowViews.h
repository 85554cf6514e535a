#pragma once

#include <vector>

#include "source/view/Drawing.h"
#include "source/view/preview/PreviewLights.h"

namespace ray {

/// So many views of the scene at most: 96 MB of depths.
inline constexpr std::size_t most_shadow_views = 24;

/// How lights see the scene, for shadow maps.
struct ShadowViews {
  std::vector<ClipMatrix> clip_from_drawing;  // at most most_shadow_views
  /// Of each light: 0 where it casts no shadows, k + 1 where view k sees all that it lights, -k - 1 where six do from k
  /// on, towards +x, -x, +y, -y, +z, -z.
  std::vector<int> first;
};

/// One view along a light that is infinitely far, and from one that is outside of the scene or a narrow spot; six from
/// others. The first lights come first, as far as there is room. What is nearer to a light than its own radius casts no
/// shadow: it may be the lamp. Only what is in the scene's sphere does, whatever is drawn around it.
///   source   Williams, Casting curved shadows on curved surfaces (1978)
ShadowViews ShadowViewsOf(const std::vector<PreviewLight>& lights);

}  // namespace ray
