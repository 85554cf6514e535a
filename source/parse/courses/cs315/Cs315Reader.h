#pragma once

#include <string>
#include <vector>

#include "source/parse/courses/objects/ObjectReader.h"

namespace ray {

/// A reader of scenes of the course CS 315, JSON with camera, lights, materials and surfaces. In addition to the
/// course's two shapes, Sphere and Triangle, surfaces may be those of ObjectReader, in lower case and with their keys
/// there.
class Cs315Reader {
 public:
  Cs315Reader(const ParseOptions& options, const Document& document, Assets& assets, Report& report)
      : report_(document, report), objects_(options, assets, report_) {}

  Scene Read();

 private:
  void ReadCamera(Mapping& scene);
  void ReadLight(const Field& field);
  void ReadMaterial(const Field& field);
  void ReadSurface(const Field& field);
  std::optional<PlacedShape> ReadShape(const std::string& name, Mapping& surface, bool has_texture);
  /// Returns the product of the transforms in file order: the last one is applied to the shape first.
  std::optional<R3::Matrix> ReadTransforms(const Field& field);
  std::optional<R3::Matrix> ReadTransform(const Field& field);

  void Set(const std::string& option, const std::string& value, const Value* said = nullptr);
  Scene& Made() { return objects_.Builder().scene; }

  DocumentReport report_;
  ObjectReader objects_;
  double exposure_time_ = 1;    // duration of the exposure, in the unit of velocities
  std::vector<int> materials_;  // of the file, as indices into Scene::materials
};

}  // namespace ray
