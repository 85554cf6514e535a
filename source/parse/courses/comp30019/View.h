#pragma once

#include "source/scene/Camera.h"

namespace ray::comp30019 {

/// The course's camera in our world, the mirror image of its own: 60 degrees of width whatever the size, in the
/// course's world at the origin and looking along +z until it is turned and then moved.
///   axis      of the turn; not zero unless `degrees` is
///   degrees   by the formula of Rodrigues in the course's left-handed world: about +x, +z turns to -y
///   source    Rodrigues, Des lois géométriques qui régissent les déplacements d'un système solide (1840)
Camera ViewFrom(const R3::Vector& position, const R3::Vector& axis, double degrees);

}  // namespace ray::comp30019
