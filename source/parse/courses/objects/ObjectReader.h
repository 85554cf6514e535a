#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "R3/Matrix.h"
#include "R3/Shape.h"
#include "source/parse/Assets.h"
#include "source/parse/Parse.h"
#include "source/parse/SceneBuilder.h"
#include "source/parse/document/Mapping.h"

namespace ray {

/// A shape and its placement.
struct PlacedShape {
  std::shared_ptr<const R3::Shape> shape;
  std::optional<R3::Matrix> placement{};         // from the shape's to its object's coordinates
  std::optional<R3::Box> bounds{};               // of the shape, if already known
  std::shared_ptr<const Assets::Model> model{};  // replaces the shape
};

/// A reader of the geometry of objects in YAML and JSON scenes. Each kind is a line of a table with its keys; the keys
/// are those of Groningen's scenes and the variants that its students use.
class ObjectReader {
 public:
  ObjectReader(const ParseOptions& options, Assets& assets, DocumentReport& report)
      : report_(report), options_(options), assets_(assets) {}

  /// Returns all names of kinds that Read accepts, including aliases.
  static std::vector<std::string_view> Kinds();
  static bool IsKind(std::string_view name);

  /// Reads the keys of one kind without calling Finish. Returns std::nullopt after a mistake, which it reports.
  ///   has_texture   gives a sphere the texture coordinates of these languages, whose poles are on the z axis; other
  ///                 shapes have only one kind of coordinates
  std::optional<PlacedShape> Read(std::string_view name, Mapping& object, bool has_texture);

  /// Adds a node that is placed by `transform` (to its parent's coordinates) and moves by `motion` during the exposure.
  /// Also called after mistakes in the scene; then nothing is added.
  void Add(Mapping& object, PlacedShape placed, const std::optional<R3::Matrix>& transform, const R3::Vector& motion,
           int material);

  /// Adds the csg of solids by its key `operation`: union, intersection or difference. Calls Finish.
  ///   parts       the key of their list
  ///   read_part   reads each of them and adds it as any object is added
  void AddCsg(Mapping& object, std::string_view parts, const std::optional<R3::Matrix>& transform,
              const R3::Vector& motion, int material, const std::function<void(const Field&)>& read_part);

  /// Returns a texture; null, with an error report, if the file cannot be read.
  std::shared_ptr<const Texture> Image(const Field& name, Assets::Use use);
  std::shared_ptr<const Environment> EnvironmentNamed(const Field& name);
  Assets::BoxedMesh MeshNamed(const Field& name, const Assets::Shading& shading);
  std::shared_ptr<const Assets::Model> ModelNamed(const Field& name, const Assets::Shading& shading);

  SceneBuilder& Builder() { return builder_; }
  DocumentReport& Reporter() { return report_; }
  /// Returns the scene with the files that it names.
  Scene Finish();

 private:
  template <class Function>
  void WithFile(const Field& name, const Function& read);
  /// Opens a group that places a node; CloseGroup closes it.
  void OpenPlace(Mapping& object, const R3::Matrix& transform, const R3::Vector& motion);
  /// Returns true if a node can be added at the builder's position; otherwise reports why not.
  bool MayAdd(Mapping& object, const Node& node, const R3::Vector& motion);
  /// Returns the nodes of a placed shape, in one material unless it has its own.
  std::vector<Node> NodesOf(Mapping& object, const PlacedShape& placed, int material);

  DocumentReport& report_;
  const ParseOptions& options_;
  Assets& assets_;
  SceneBuilder builder_;
};

}  // namespace ray
