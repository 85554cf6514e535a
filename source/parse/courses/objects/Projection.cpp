#include "source/parse/courses/objects/Projection.h"

#include "source/text/Quoting.h"

namespace ray {
namespace {

const CameraKind& KindOf(Mapping& mapping, const Camera& camera) {
  const auto name = mapping.Find({"projection"});
  const auto which = name ? name->Choice(CameraKindNames(), "projections") : std::nullopt;
  return which ? *CameraKinds()[*which] : *camera.kind;
}

/// A number that only some kinds of camera have.
void ReadExtent(Mapping& mapping, const char* key, bool is_known, Camera& camera) {
  const auto field = mapping.Find({key});
  if (!field) return;
  const std::string what = std::string("projection ") + camera.kind->name;
  if (!is_known) return field->Error("has no meaning with " + what);
  const auto extent = field->Number();
  if (extent && !IsExtent(*camera.kind, *extent))
    return field->Error("must be " + std::string(RangeOfExtent(*camera.kind)) + " with " + what + ", got " +
                        Escaped(field->What().scalar));
  camera.extent = extent.value_or(0);
}

}  // namespace

void ReadProjection(Mapping& mapping, Camera& camera) {
  camera.kind = &KindOf(mapping, camera);
  ReadExtent(mapping, "fov", camera.kind->extent == CameraExtent::angle && !camera.IsPinhole(), camera);
  ReadExtent(mapping, "viewWidth", camera.kind->extent == CameraExtent::width, camera);
}

}  // namespace ray
