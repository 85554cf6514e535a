#pragma once

#include "source/scene/Camera.h"

namespace ray::comp30019 {

/// Returns the course's camera in our world, the mirror image of its own: 60 degrees wide for any size. In the course's
/// world, it is at the origin and looks along +z until it is rotated and then moved.
///   axis      of the rotation; not zero unless `degrees` is
///   degrees   by the formula of Rodrigues in the course's left-handed world: about +x, +z turns to -y
///   source    Rodrigues, Des lois géométriques qui régissent les déplacements d'un système solide (1840)
Camera ViewFrom(const R3::Vector& position, const R3::Vector& axis, double degrees);

}  // namespace ray::comp30019
