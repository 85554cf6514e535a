#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "R3/Matrix.h"
#include "R3/Shape.h"
#include "source/parse/Assets.h"
#include "source/parse/Parse.h"
#include "source/parse/SceneBuilder.h"
#include "source/parse/document/Mapping.h"

namespace ray {

/// A shape and where it stands.
struct PlacedShape {
  std::shared_ptr<const R3::Shape> shape;
  std::optional<R3::Matrix> placement{};         // of the shape in its object's coordinates
  std::optional<R3::Box> bounds{};               // of the shape, where they are known already
  std::shared_ptr<const Assets::Model> model{};  // instead of a shape
};

/// The geometry of objects in YAML and JSON scenes. Each kind is a line of a table with the keys that describe it; the
/// keys are those of Groningen's scenes and the spellings that its students use.
class ObjectReader {
 public:
  ObjectReader(const ParseOptions& options, Assets& assets, DocumentReport& report)
      : report_(report), options_(options), assets_(assets) {}

  /// Every name of a kind that Read knows, aliases included.
  static std::vector<std::string_view> Kinds();
  static bool IsKind(std::string_view name);

  /// Reads the keys of one kind, not calling Finish. Returns nothing after a mistake, which it reports.
  ///   has_texture   gives a sphere the texture coordinates of these languages, whose poles are on the z axis; other
  ///                 shapes have one kind of them only
  std::optional<PlacedShape> Read(std::string_view name, Mapping& object, bool has_texture);

  /// A node that is moved by `transform` (its parent's coordinates from its own) and by `motion` while the shutter is
  /// open. To be called with mistakes in the scene as well: then nothing is added.
  void Add(Mapping& object, PlacedShape placed, const std::optional<R3::Matrix>& transform, const R3::Vector& motion,
           int material);

  /// Adds what the solids of a csg make by its key `operation`: union, intersection or difference. Calls Finish.
  ///   parts       the key of their list
  ///   read_part   reads each of them and adds it as any object is added
  void AddCsg(Mapping& object, std::string_view parts, const std::optional<R3::Matrix>& transform,
              const R3::Vector& motion, int material, const std::function<void(const Field&)>& read_part);

  /// Null, and a mistake told, where the file cannot be read.
  std::shared_ptr<const Texture> Image(const Field& name, Assets::Use use);
  std::shared_ptr<const Environment> EnvironmentNamed(const Field& name);
  Assets::BoxedMesh MeshNamed(const Field& name, const Assets::Shading& shading);
  std::shared_ptr<const Assets::Model> ModelNamed(const Field& name, const Assets::Shading& shading);

  SceneBuilder& Builder() { return builder_; }
  DocumentReport& Reporter() { return report_; }
  /// The scene as it is, with the files that it names.
  Scene Finish();

 private:
  template <class Function>
  void WithFile(const Field& name, const Function& read);
  /// Opens what places a node, closed again by CloseGroup.
  void OpenPlace(Mapping& object, const R3::Matrix& transform, const R3::Vector& motion);
  /// Whether a node can be added where the builder stands; else it tells why not.
  bool MayAdd(Mapping& object, const Node& node, const R3::Vector& motion);
  /// What a placed shape is made of, in one material unless it has its own.
  std::vector<Node> NodesOf(Mapping& object, const PlacedShape& placed, int material);

  DocumentReport& report_;
  const ParseOptions& options_;
  Assets& assets_;
  SceneBuilder builder_;
};

}  // namespace ray
