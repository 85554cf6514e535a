#pragma once

#include <vector>

#include "source/draw/Drawing.h"
#include "source/draw/preview/PreviewLights.h"

namespace ray {

/// So many views of the scene at most: 96 MB of depths.
inline constexpr std::size_t most_shadow_views = 24;
/// Places on a light that has a size: its middle, and six about it at two thirds of its area.
inline constexpr int places_of_light = 7;

/// How lights see the scene, for shadow maps.
struct ShadowViews {
  std::vector<ClipMatrix> clip_from_drawing;  // at most most_shadow_views
  /// For each light: 0 if it casts no shadows, k + 1 if view k sees all that it lights, -k - 1 if the six views from k
  /// on do, towards +x, -x, +y, -y, +z, -z.
  std::vector<int> first;
  /// For each light, the number of places on it from which a view sees all that it lights; 1 where six views do.
  std::vector<int> places;
};

/// One view along a light that is infinitely far, and from one that is outside of the scene or a narrow spot; six from
/// others. Discs, and spheres outside of the scene, are looked from at places_of_light places where there is room, for
/// soft shadows; what lies more than 75 degrees to the side of a disc in the scene casts no shadow. The first lights
/// come first, as far as there is room. What is nearer to a light than its own radius casts no shadow: it may be the
/// lamp. Only what is in the scene's sphere does, whatever is drawn around it.
///   source   Williams, Casting curved shadows on curved surfaces (1978)
///   most   views, at most most_shadow_views
ShadowViews ShadowViewsOf(const std::vector<PreviewLight>& lights, std::size_t most = most_shadow_views);

}  // namespace ray
