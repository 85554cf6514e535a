#pragma once

#include <functional>
#include <string>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/app/options/RenderOptions.h"

namespace ray {

/// Returns the text of -check: the contents of the scene, and the memory for it and its image.
std::string SceneSummary(const World& world, const RenderSettings& settings);

/// Returns probable mistakes that every render reports: a camera inside a solid, no light, nothing in view, shapes that
/// cannot be hit... Empty for scenes so large that checking would take noticeable time.
std::vector<std::string> PlainMistakes(const World& world, const RenderSettings& settings);

/// Returns what a render also reports unless it is to be quiet: lamps that are far too bright in mode whitted, surfaces
/// of different materials in one place, lights inside solids. Traces at most 1,152 rays, and takes milliseconds.
std::vector<std::string> RenderHints(const World& world, const Accelerator& accelerator,
                                     const RenderSettings& settings);

/// Returns what -check reports: the same in any scene, and also shapes outside the view and meshes around the camera.
std::vector<std::string> LikelyMistakes(const World& world, const RenderSettings& settings);

/// Returns true if anything shines: a light, an environment, a surface, or ambient light on a surface that reflects it.
bool IsLit(const World& world);

/// Returns the position of an instance in its scene file, "room.scn:12:1".
std::string PlaceOf(const World& world, const Instance& instance);

/// Returns a box around an instance, in the world; empty for infinite shapes.
R3::Box WorldBounds(const World& world, const Instance& instance);

/// Returns true if the point is inside a solid or mesh: a ray from it crosses the surface an odd number of times. For a
/// mesh, which may be open, three rays must agree.
bool Holds(const World& world, const Instance& instance, const R3::Point& point);

/// Returns the number of instances that contain the point. `counts` selects the instances.
int SolidsAround(
    const World& world, const R3::Point& point,
    const std::function<bool(const Instance&)>& counts = [](const Instance&) { return true; });

}  // namespace ray
