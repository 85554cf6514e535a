#include "source/parse/scn/ScnReader.h"
#include "source/text/Number.h"
#include "source/text/Quoting.h"
#include "source/text/Suggestion.h"

namespace ray {
namespace {

/// An extension: how the camera's picture is laid out, and how much of the scene it shows across.
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

/// "fisheye, a circle...; latlong, ..."
std::string About() {
  std::string about =
      "how the camera's image is laid out; the number is the whole angle across in degrees, or of orthographic the "
      "width, and without it the camera's angle decides";
  for (const CameraKind* kind : CameraKinds()) about += std::string("; ") + kind->name + ": " + kind->about;
  return about;
}

}  // namespace

extern const Command projection_command{"projection", "projection name [degrees|width]", About(), ReadProjection};

}  // namespace ray
