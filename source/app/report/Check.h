#pragma once

#include <functional>
#include <string>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/app/options/RenderOptions.h"

namespace ray {

/// What -check prints: what is in the scene, and how much memory it and its picture take.
std::string SceneSummary(const World& world, const RenderSettings& settings);

/// What its author may not have meant and every render points out: a camera inside a solid, no light, nothing in view,
/// shapes that cannot be hit... Nothing for scenes so large that looking would take noticeable time.
std::vector<std::string> PlainMistakes(const World& world, const RenderSettings& settings);

/// Returns what a render points out besides, unless it is to be quiet: lamps that are far too bright in mode whitted,
/// surfaces of different materials in one place, lights inside of solids. Traces at most 1,152 rays, and takes
/// milliseconds.
std::vector<std::string> RenderHints(const World& world, const Accelerator& accelerator,
                                     const RenderSettings& settings);

/// What -check points out: the same in any scene, and also shapes outside the view and meshes around the camera.
std::vector<std::string> LikelyMistakes(const World& world, const RenderSettings& settings);

/// True if anything shines: a light, an environment, a surface, or ambient light on a surface that reflects it.
bool IsLit(const World& world);

/// The place of an instance in its scene file, "room.scn:12:1".
std::string PlaceOf(const World& world, const Instance& instance);

/// A box around an instance, in the world; empty for what has no end.
R3::Box WorldBounds(const World& world, const Instance& instance);

/// Whether a solid or mesh holds the point inside: a ray from it crosses the surface an odd number of times. A mesh does
/// only if three rays agree, for it may be open.
bool Holds(const World& world, const Instance& instance, const R3::Point& point);

/// How many hold the point inside. `counts`: which of them are asked for.
int SolidsAround(
    const World& world, const R3::Point& point,
    const std::function<bool(const Instance&)>& counts = [](const Instance&) { return true; });

}  // namespace ray
