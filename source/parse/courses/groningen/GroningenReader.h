#pragma once

#include <optional>
#include <string>

#include "source/parse/courses/objects/ObjectReader.h"

namespace ray {

/// A reader of scenes of the University of Groningen's course, Introduction to Computer Graphics (2009 to 2018), in
/// YAML or JSON. The course's special rules become settings of the scene.
class GroningenReader {
 public:
  GroningenReader(const ParseOptions& options, const Document& document, Assets& assets, Report& report)
      : report_(document, report), objects_(options, assets, report_) {}

  Scene Read();

 private:
  enum class Mode { phong, zbuffer, normal, gooch, uv, flat, toon, hatching };

  // view.cpp
  void ReadView(Mapping& scene);
  void ReadEye(const Field& field);
  void ReadCamera(const Field& field);
  void ReadLens(Mapping& camera, double focus);
  /// Reads the image size and returns the width.
  std::optional<double> ReadSize(const Field& size);
  void ReadSamples(Mapping& scene);

  // image.cpp
  void ReadImageSettings(Mapping& scene);
  void ReadMode(Mapping& scene);
  void ReadZBuffer(Mapping& scene);
  void FindRange(Mapping& mapping);
  void ReadOutline(Mapping& gooch);
  void ReadGooch(Mapping& scene);

  // objects.cpp
  void ReadLights(Mapping& scene);
  void ReadLight(const Field& field);
  void ReadObjects(Mapping& scene);
  void ReadObject(const Field& field);
  void ReadCsg(Mapping& object);
  /// Returns the displacement of an object during the exposure. StartOf returns the transform to its initial position.
  R3::Vector ReadMotion(Mapping& object) const;
  static std::optional<R3::Matrix> StartOf(const R3::Vector& motion);
  int ReadMaterial(Mapping& object);
  void ReadColors(Mapping& material, bool has_texture, Material& read);

  /// Makes a setting; values in the file override the course's rules.
  void Set(const std::string& option, const std::string& value, const Value* said = nullptr);
  Scene& Made() { return objects_.Builder().scene; }

  DocumentReport report_;
  ObjectReader objects_;
  Mode mode_ = Mode::phong;
  double exposure_time_ = 0;
  std::int64_t lens_samples_ = 1, time_samples_ = 1;
  std::optional<Field> near_, far_;  // of the z-buffer, wherever they appear
};

}  // namespace ray
