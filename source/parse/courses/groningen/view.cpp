#include <array>
#include <cmath>
#include <limits>

#include "R1/Elementary.h"
#include "source/parse/courses/groningen/GroningenReader.h"
#include "source/parse/courses/objects/SharedKeys.h"
#include "source/text/LowerCase.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr int usual_side = 400;  // pixels; the size of an image whose file states none

constexpr double usual_distance = 1000;  // from the eye to the image plane, in the course's own scenes

constexpr std::int64_t most = std::numeric_limits<int>::max();

/// Returns the vector from the eye to the center of the image. Students give a direction instead, whose length is
/// unspecified.
R3::Vector WayToCenter(Mapping& camera, const R3::Point& eye) {
  const auto direction = camera.Has({"center"}) ? std::nullopt : camera.Find({"direction"});
  if (!direction) return camera.NeedPoint({"center"}) - eye;
  const R3::Vector way = direction->Vector().value_or(R3::Vector{0, 0, -1});
  if (way == R3::Vector{}) direction->Error("must not be 0 0 0: it is a direction");
  return usual_distance * Unit(way);
}

/// Returns a factor, which may also be a Boolean, as in students' programs: true is the factor of the course's
/// examples.
std::int64_t FactorOf(const Field& field) {
  constexpr std::int64_t usual = 2;
  const std::string word = LowerCase(field.What().scalar);
  if (word == "true" || word == "yes" || word == "on") return usual;
  if (word == "false" || word == "no" || word == "off") return 1;
  return field.Whole(1, most).value_or(1);
}

}  // namespace

void GroningenReader::ReadView(Mapping& scene) {
  Set("width", ToText(usual_side));
  Set("height", ToText(usual_side));
  const auto eye = scene.Find({"Eye", "eye"}), camera = scene.Find({"Camera", "camera"});
  if (camera)
    ReadCamera(*camera);
  else if (eye)
    ReadEye(*eye);
  else
    report_.Error(scene.What(), "has no view", "it needs Eye, or Camera with eye, center and up");
  if (const auto size = scene.Find({"ImageSize"})) ReadSize(*size);
  ReadSamples(scene);
}

// The image is the square from 0 to 400 in the plane z = 0, with pixels one unit wide. The eye need not be in front of
// its center: the camera looks straight at the plane and is shifted.
void GroningenReader::ReadEye(const Field& field) {
  const auto eye = field.Vector();
  if (!eye) return;
  if (eye->z == 0)
    return field.Error("must not have z = 0: the image's plane is there",
                       "a Camera with eye, center and up may be anywhere");
  constexpr double half = usual_side / 2.0;
  Camera& camera = Made().camera;
  camera.eye = R3::Point{} + *eye;
  camera.towards = {0, 0, eye->z > 0 ? -1.0 : 1.0};
  camera.xfov = R1::Atan2(half, std::abs(eye->z));
  camera.shift = {(half - eye->x) / half, (half - eye->y) / half};
}

void GroningenReader::ReadCamera(const Field& field) {
  auto camera = field.AsMapping("a camera");
  if (!camera) return;
  const R3::Point eye = camera->NeedPoint({"eye", "position"});
  const R3::Vector towards = WayToCenter(*camera, eye), up = camera->Vector({"up"}).value_or(R3::Vector{0, 1, 0});
  double width = usual_side;
  if (const auto size = camera->Find({"viewSize", "ViewSize", "size"})) width = ReadSize(*size).value_or(width);
  ReadLens(*camera, Length(towards));
  FindRange(*camera);
  const R3::Vector velocity = camera->Vector({"velocity"}).value_or(R3::Vector{});
  Camera projected;
  ReadProjection(*camera, projected);
  camera->Ignore({"comment", "name"});
  if (!camera->FinishedWell()) return;
  if (towards == R3::Vector{}) return report_.Error(camera->What(), "has its eye at its center");
  const AimedCamera aimed = Aim(eye, towards, up);
  if (aimed.up_was_replaced) return report_.Error(camera->What(), "has an up vector along the view direction");
  Made().camera = aimed.camera;
  Made().camera.TakeViewOf(projected);
  if (const R3::Vector displacement = exposure_time_ * velocity; !(displacement == R3::Vector{})) {
    Made().camera.eye = eye - displacement / 2;  // it is at its position in the middle of the exposure
    Set("motion", ToText(displacement.x) + " " + ToText(displacement.y) + " " + ToText(displacement.z), &field.What());
  }
  // A pixel is as wide as the length of `up`, in the plane through the center.
  Made().camera.xfov = R1::Atan2(width / 2 * Length(up), Length(towards));
  if (projected.kind->extent == CameraExtent::width && projected.extent == 0) Made().camera.extent = width * Length(up);
}

std::optional<double> GroningenReader::ReadSize(const Field& size) {
  const auto both = size.ListOf(2, "a list of a width and a height in pixels");
  if (!both) return {};
  const auto width = (*both)[0].Whole(1, most), height = (*both)[1].Whole(1, most);
  if (!width || !height) return {};
  Set("width", ToText(*width), &size.What());
  Set("height", ToText(*height), &size.What());
  return static_cast<double>(*width);
}

void GroningenReader::ReadLens(Mapping& camera, double focus) {
  const auto radius = camera.Find({"apertureRadius"});
  const double aperture = radius ? radius->Number(not_negative).value_or(0) : 0;
  const std::int64_t lens_samples = camera.Whole({"apertureSamples"}, 1, 1);
  const bool is_turned = camera.Bool({"apertureJitter"}, true);
  if (aperture > 0) {
    lens_samples_ = lens_samples;
    Set("aperture", ToText(aperture), &radius->What());
    Set("focus", ToText(focus), &radius->What());  // the plane through the center
    Set("lens", is_turned ? "spiral" : "fixed_spiral");
    Set("lens_samples", ToText(lens_samples), &radius->What());
  }
  exposure_time_ = camera.Number({"exposureTime"}, not_negative, 0);
  const auto moments = camera.Find({"exposureSamples"});
  const std::int64_t time_samples = moments ? moments->Whole(1, most).value_or(1) : 1;
  if (time_samples == 1) exposure_time_ = 0;  // one sample is the sharp image at the middle of the exposure
  if (!(exposure_time_ > 0)) return;
  time_samples_ = time_samples;
  Set("shutter_samples", ToText(time_samples), &moments->What());
}

// Each point of a pixel gets one ray for each combination of lens point and moment of the exposure.
void GroningenReader::ReadSamples(Mapping& scene) {
  static constexpr std::array<std::string_view, 6> patterns{"grid",    "jitter",   "random",
                                                            "rotated", "adaptive", "poisson"};
  constexpr std::array samplers{"grid", "stratified", "random", "rotated_grid", "grid", "poisson"};
  static_assert(samplers.size() == patterns.size());
  std::int64_t factor = 1;
  std::size_t pattern = 0;
  const Value* said = nullptr;
  if (const auto field = scene.Find({"SuperSampling", "SuperSamplingFactor", "AntiAliasing", "SuperSample"})) {
    said = &field->What();
    if (field->IsMapping()) {
      Mapping sampling(report_, *said, "SuperSampling");
      factor = sampling.Whole({"factor", "Factor"}, 1, 1);
      if (const auto name = sampling.Find({"pattern"})) pattern = name->Choice(patterns, "patterns").value_or(0);
      sampling.Ignore({"comment"});
      sampling.Finish();
    } else {
      factor = FactorOf(*field);
    }
  }
  const auto side = static_cast<double>(factor);
  const double samples = side * side * static_cast<double>(lens_samples_) * static_cast<double>(time_samples_);
  if (samples > std::numeric_limits<int>::max())
    return report_.Error(said ? *said : scene.What(), "requests more than 2147483647 samples per pixel");
  Set("samples", ToText(static_cast<std::int64_t>(samples)), said);
  Set("sampler", samplers[pattern], said);
  if (patterns[pattern] == "adaptive") Set("adaptive", "neighbors", said);
}

}  // namespace ray
