#include "source/parse/courses/comp30019/View.h"

#include <numbers>

namespace ray::comp30019 {
namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr double half_field_of_view = 30 * radians;

R3::Vector MirrorImage(const R3::Vector& v) { return {v.x, v.y, 0 - v.z}; }

}  // namespace

Camera ViewFrom(const R3::Vector& position, const R3::Vector& axis, double degrees) {
  const R3::Vector k = Unit(axis);
  const auto turned = [&](const R3::Vector& v) {
    return MirrorImage(degrees == 0 ? v : R3::Turned(v, k, degrees * radians));
  };
  Camera camera;
  camera.eye = R3::Point{} + MirrorImage(position);
  camera.right = turned({1, 0, 0});
  camera.up = turned({0, 1, 0});
  camera.towards = turned({0, 0, 1});
  camera.xfov = half_field_of_view;
  return camera;
}

}  // namespace ray::comp30019
