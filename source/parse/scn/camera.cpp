#include <array>
#include <numbers>

#include "source/parse/scn/Placing.h"
#include "source/parse/scn/ScnReader.h"
#include "source/text/Number.h"
#include "source/text/Quoting.h"
#include "source/text/Suggestion.h"

namespace ray {
namespace {

constexpr auto camera_arguments =
    R3::ArgumentsNamed("ex", "ey", "ez", "tx", "ty", "tz", "ux", "uy", "uz", "xfov", "near", "far");

void CheckView(Statement& statement, const Arguments& read) {
  constexpr std::size_t tx = 3, xfov = 9;
  const auto& a = read.values;
  if (a[tx] == 0 && a[tx + 1] == 0 && a[tx + 2] == 0)
    statement.Error(read.words[tx], "the view direction must not be 0 0 0", "tx ty tz is a direction, not a point");
  if (!(a[xfov] > 0 && a[xfov] < std::numbers::pi / 2))
    statement.Error(read.words[xfov], "xfov must be between 0 and pi/2, got " + Escaped(read.words[xfov].text),
                    "half the horizontal field of view, in radians");
}

/// Reads an eye, a direction and half an angle in radians, as in the course.
std::optional<AimedCamera> ReadDirected(Statement& statement) {
  const Arguments read = statement.Numbers(camera_arguments);
  if (statement.IsGood()) CheckView(statement, read);
  if (!statement.IsGood()) return {};
  const auto& a = read.values;
  AimedCamera aimed = Aim({a[0], a[1], a[2]}, {a[3], a[4], a[5]}, {a[6], a[7], a[8]});
  aimed.camera.xfov = a[9];
  aimed.camera.near = a[10];
  aimed.camera.far = a[11];
  return aimed;
}

constexpr std::string_view look_at_usage = "camera look_at ex ey ez tx ty tz ux uy uz fov";
constexpr auto whole_angle = R3::ArgumentsNamed("fov");

/// Reads an extension: an eye, a target and a whole angle in degrees.
std::optional<AimedCamera> ReadLookingAt(Statement& statement) {
  statement.BeginPart("camera look_at", look_at_usage);
  const Arguments read = statement.Coordinates(look_at_arguments), angle = statement.Numbers(whole_angle);
  const double fov = angle.values[0];
  if (!statement.IsGood()) return {};
  const auto& a = read.values;
  const R3::Point eye{a[0], a[1], a[2]}, target{a[3], a[4], a[5]};
  if (eye == target) statement.Error(read.words[3], "the camera must not be at the point that it looks at");
  if (!(fov > 0 && fov < 180))
    statement.Error(angle.words[0], "fov must be between 0 and 180, got " + Escaped(angle.words[0].text),
                    "the whole horizontal field of view, in degrees");
  if (!statement.IsGood()) return {};
  AimedCamera aimed = Aim(eye, target - eye, {a[6], a[7], a[8]});
  aimed.camera.SetFov(fov);
  return aimed;
}

void ReadCamera(ScnReader& reader, Statement& statement) {
  if (reader.ReplacesCamera()) reader.Warn(statement, "the scene already has a camera; the last one counts");
  auto aimed = statement.Takes("look_at") ? ReadLookingAt(statement) : ReadDirected(statement);
  if (!aimed) return;
  if (aimed->up_was_replaced)
    reader.Warn(statement, "the up vector is parallel to the view direction; another one is used");
  aimed->camera.TakeViewOf(reader.Builder().scene.camera);  // a view line may come first
  reader.Builder().scene.camera = aimed->camera;
}

const std::array<R3::Argument, 3> view_arguments{{{"aspect", false}, {"shift_x"}, {"shift_y"}}};

/// Reads an extension: a view other than a centered one with square pixels.
void ReadView(ScnReader& reader, Statement& statement) {
  const auto a = statement.Numbers(view_arguments).values;
  const bool is_mirrored = statement.Takes("mirrored");
  if (!statement.IsGood()) return;
  Camera& camera = reader.Builder().scene.camera;
  camera.aspect = a[0];
  camera.shift = {a[1], a[2]};
  if (camera.IsMirrored() != is_mirrored) camera.right = -camera.right;
}

/// Reads an extension: the camera's projection, and its horizontal extent.
void ReadProjection(ScnReader& reader, Statement& statement) {
  const Token name = statement.Word("name");
  const CameraKind* kind = FindCameraKind(name.text);
  const auto number = statement.TakesNumber();
  if (!kind)
    return statement.Error(name, "unknown projection " + Quoted(name.text),
                           Suggestion(name.text, CameraKindNames(), "projections"));
  double extent = 0;
  if (number) {
    const auto [value, problem] = ParseNumber(number->text);
    if (kind->extent == CameraExtent::none || kind == &pinhole_camera)
      return statement.Error(*number, "projection " + std::string(kind->name) + " takes no number",
                             kind == &pinhole_camera ? "the angle is that of the camera" : "it shows the whole sphere");
    if (problem || !IsExtent(*kind, value))
      return statement.Error(*number, "projection " + std::string(kind->name) + " must have " + RangeOfExtent(*kind) +
                                          ", got " + Escaped(number->text));
    extent = value;
  }
  Camera& camera = reader.Builder().scene.camera;
  camera.kind = kind;
  camera.extent = extent;
}

/// Returns "fisheye, a circle...; latlong, ...".
std::string About() {
  std::string about =
      "the camera's projection; the number is the whole horizontal angle in degrees, or for orthographic the width; by "
      "default the camera's angle decides";
  for (const CameraKind* kind : CameraKinds()) about += std::string("; ") + kind->name + ": " + kind->about;
  return about;
}

}  // namespace

extern const Command camera_command{
    "camera", "camera" + ArgumentNames(camera_arguments),
    "eye, view direction, up, half the horizontal field of view in radians, clipping planes of the viewer; or "
    "look_at ex ey ez tx ty tz ux uy uz fov: eye, a point to look at, up, the whole horizontal field of view in "
    "degrees",
    ReadCamera};

extern const Command view_command{
    "view", "view" + ArgumentNames(view_arguments) + " [mirrored]",
    "width over height of the view, 0 for that of the image; offset of the image's center from the axis, to the right "
    "and up, in half widths; mirrored swaps left and right",
    ReadView};

extern const Command projection_command{"projection", "projection name [degrees|width]", About(), ReadProjection};

}  // namespace ray
