#include <array>
#include <numbers>

#include "R1/Elementary.h"
#include "R3/Placement.h"
#include "source/parse/courses/objects/Kinds.h"

namespace ray {
namespace {

/// The orientation of a sphere's texture: the transform to the world from a globe whose north pole is +z, with
/// longitude 0 at +x and increasing counter-clockwise, as in Groningen's course.
struct Globe {
  R3::Matrix world_from_globe;
  bool is_turned = false;  // an orientation is given
};

/// Reads a nonzero axis.
std::optional<R3::Vector> Axis(const std::optional<Field>& field) {
  const auto axis = field ? field->Vector() : std::nullopt;
  if (!axis) return {};
  if (*axis == R3::Vector{}) {
    field->Error("must not be 0 0 0: it is a direction");
    return {};
  }
  return Unit(*axis);
}

/// Returns the rotation with the pole at `axis`, and longitude 0 at the perpendicular part of `side`.
std::optional<R3::Matrix> FromSide(const Field& side, const R3::Vector& axis) {
  const auto given = Axis(side);
  if (!given) return {};
  const R3::Vector y = Cross(axis, *given);
  if (!(Length(y) > 0)) {
    side.Error("must not be parallel to the axis");
    return {};
  }
  return Frame({}, Cross(Unit(y), axis), Unit(y), axis);
}

/// Returns the rotation of the quaternion w, x, y, z.
std::optional<R3::Matrix> FromQuaternion(const Field& field) {
  const auto fields = field.ListOf(4, "a list of four numbers: w, x, y, z");
  if (!fields) return {};
  std::vector<double> q;
  for (const Field& f : *fields)
    if (const auto number = f.Number()) q.push_back(*number);
  if (q.size() < 4) return {};
  const double length = R1::Hypot(q[0], R3::Length({q[1], q[2], q[3]}));
  if (!(length > 0)) {
    field.Error("must not be 0 0 0 0");
    return {};
  }
  const double w = q[0] / length, x = q[1] / length, y = q[2] / length, z = q[3] / length;
  return R3::Frame({}, {1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
                   {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
                   {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)});
}

/// The radius alone, or a list of the radius and the axis.
struct RadiusAndAxis {
  double radius = 0;
  std::optional<R3::Vector> axis;
};
RadiusAndAxis ReadRadius(Mapping& object) {
  RadiusAndAxis read;
  const auto field = object.Need({"radius", "r"});
  if (!field) return read;
  if (!field->IsList()) {
    read.radius = field->Number(positive).value_or(0);
    return read;
  }
  if (const auto both = field->ListOf(2, "a number, or a list of a number and an axis")) {
    read.radius = (*both)[0].Number(positive).value_or(0);
    read.axis = Axis((*both)[1]);
  }
  return read;
}

Globe ReadGlobe(Mapping& object, const std::optional<R3::Vector>& axis_with_radius) {
  const auto axis_field = object.Find({"axis", "rotation", "north"});
  const auto side = object.Find({"side", "start"});
  const auto quaternion = object.Find({"quaternion"});
  const double angle = object.Number({"angle"}, any_number, 0);
  const R3::Vector z{0, 0, 1};
  const auto named = axis_with_radius ? axis_with_radius : Axis(axis_field);
  const R3::Vector axis = named.value_or(z);
  std::optional<R3::Matrix> turned;
  if (quaternion)
    turned = FromQuaternion(*quaternion);
  else if (side)
    turned = FromSide(*side, axis);
  else
    turned = SmallestRotation(z, axis);
  return {turned.value_or(R3::Matrix{}) * R3::RotationAbout(2, angle), named || side || quaternion || angle != 0};
}

// Our own sphere also has the poles of its texture on z, but its longitude increases clockwise from +y: a globe with x
// and y swapped.
std::optional<PlacedShape> ReadSphere(ObjectReader&, Mapping& object, bool has_texture) {
  const R3::Point center = object.NeedPoint({"position", "center"});
  const RadiusAndAxis read = ReadRadius(object);
  const Globe globe = ReadGlobe(object, read.axis);
  if (!object.IsGood()) return {};
  if (!has_texture && !globe.is_turned)
    return PlacedShape{ShapeOf("sphere", std::array{center.x, center.y, center.z, read.radius})};
  const R3::Matrix globe_from_sphere = R3::Frame({}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1});
  const R3::Matrix placement = Translation(FromOrigin(center)) * globe.world_from_globe * globe_from_sphere;
  return PlacedShape{ShapeOf("sphere", std::array{0.0, 0.0, 0.0, read.radius}), placement};
}

}  // namespace

extern const std::vector<ObjectKind> sphere_kinds{{{"sphere"}, nullptr, ReadSphere}};

}  // namespace ray
