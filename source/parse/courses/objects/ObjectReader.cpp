#include "source/parse/courses/objects/ObjectReader.h"

#include <algorithm>

#include "R3/Placement.h"
#include "source/parse/CsgOf.h"
#include "source/parse/courses/objects/Kinds.h"
#include "source/scene/Singular.h"

namespace ray {
namespace {

std::span<const ObjectKind> ObjectKinds() {
  static const std::vector<ObjectKind> all = [] {
    std::vector<ObjectKind> kinds;
    for (const auto* some : {&sphere_kinds, &flat_kinds, &solid_kinds, &surface_kinds})
      kinds.insert(kinds.end(), some->begin(), some->end());
    return kinds;
  }();
  return all;
}

const ObjectKind* FindKind(std::string_view name) {
  for (const ObjectKind& kind : ObjectKinds())
    if (std::ranges::find(kind.names, name) != kind.names.end()) return &kind;
  return nullptr;
}

std::string WithExtension(const std::string& mesh) {
  const std::size_t slash = mesh.find_last_of('/');
  const bool has_extension = mesh.find('.', slash == std::string::npos ? 0 : slash + 1) != std::string::npos;
  return has_extension ? mesh : mesh + ".obj";
}

}  // namespace

std::shared_ptr<const R3::Shape> ShapeOf(const char* kind, std::span<const double> numbers) {
  return R3::FindShapeKind(kind)->make(numbers);
}

std::vector<std::string_view> ObjectReader::Kinds() {
  std::vector<std::string_view> names;
  for (const ObjectKind& kind : ObjectKinds()) names.insert(names.end(), kind.names.begin(), kind.names.end());
  return names;
}

bool ObjectReader::IsKind(std::string_view name) { return FindKind(name); }

std::optional<PlacedShape> ObjectReader::Read(std::string_view name, Mapping& object, bool has_texture) {
  try {
    const ObjectKind& kind = *FindKind(name);
    return kind.read ? kind.read(object) : kind.read_with(*this, object, has_texture);
  } catch (const R3::ArgumentError& error) {
    report_.Error(object.What(), std::string("cannot be: ") + error.what());
    return {};
  }
}

std::vector<Node> ObjectReader::NodesOf(Mapping& object, const PlacedShape& placed, int material) {
  if (placed.model) return builder_.NodesOf(placed.model, material);
  if (placed.shape->IsDegenerate()) report_.Warn(object.What().extent, "degenerate: no ray can hit it");
  std::vector<Node> nodes(1);
  nodes[0].shape = placed.shape;
  nodes[0].material = material;
  if (placed.bounds)
    nodes[0].bounds = *placed.bounds;
  else
    SetBounds(nodes[0]);
  return nodes;
}

void ObjectReader::Add(Mapping& object, PlacedShape placed, const std::optional<R3::Matrix>& transform,
                       const R3::Vector& motion, int material) {
  const bool needs_group = placed.placement || transform || !(motion == R3::Vector{});
  std::vector<Node> nodes = NodesOf(object, placed, material);
  if (builder_.nodes + nodes.size() > options_.max_nodes)
    return report_.Error(object.What(), "is one node too many: the scene has more than " +
                                            std::to_string(options_.max_nodes) + " nodes");
  for (const Node& node : nodes)
    if (!MayAdd(object, node, motion)) return;
  const R3::Matrix outer = transform.value_or(R3::Matrix{});
  if (needs_group) OpenPlace(object, placed.placement ? outer * *placed.placement : outer, motion);
  for (Node& node : nodes) {
    node.location = LocationOf(0, report_.At(object.What().extent));
    builder_.Add(std::move(node));
  }
  if (needs_group) builder_.CloseGroup();
}

void ObjectReader::OpenPlace(Mapping& object, const R3::Matrix& transform, const R3::Vector& motion) {
  if (IsSingular(transform)) report_.Warn(object.What().extent, "singular transform: it is not rendered");
  Node group;
  group.location = LocationOf(0, report_.At(object.What().extent));
  group.transform = transform;
  group.motion = motion;
  builder_.OpenGroup(std::move(group));
}

bool ObjectReader::MayAdd(Mapping& object, const Node& node, const R3::Vector& motion) {
  if (!builder_.IsInCsg() && !node.operation) return true;
  auto fault = builder_.FaultOfCsg(node);
  if (!fault && builder_.IsInCsg() && !(motion == R3::Vector{}))
    fault = CsgFault{"solids of a csg cannot move on their own", "velocity of all of the csg moves it"};
  if (fault) report_.Error(object.What(), std::string(": ") + fault->message, fault->hint);
  return !fault;
}

void ObjectReader::AddCsg(Mapping& object, std::string_view parts, const std::optional<R3::Matrix>& transform,
                          const R3::Vector& motion, int material, const std::function<void(const Field&)>& read_part) {
  const auto word = object.Need({"operation"}), list = object.Need({parts});
  const auto operation = word ? word->Choice(csg_operations, "operations") : std::nullopt;
  const auto solids = list ? list->List() : std::nullopt;
  if (!object.FinishedWell() || !operation || !solids) return;
  Node csg;
  csg.location = LocationOf(0, report_.At(object.What().extent));
  csg.operation = static_cast<R3::CsgOperation>(*operation);
  csg.material = material;
  if (!MayAdd(object, csg, motion)) return;
  OpenPlace(object, transform.value_or(R3::Matrix{}), motion);
  builder_.OpenGroup(std::move(csg));
  for (const Field& solid : *solids) read_part(solid);
  builder_.CloseGroup();
  const Node& closed = builder_.open_groups.back().children.back();
  if (closed.shape && closed.shape->IsDegenerate()) report_.Warn(object.What().extent, "empty: no ray can hit it");
  builder_.CloseGroup();
}

template <class Function>
void ObjectReader::WithFile(const Field& name, const Function& read) {
  try {
    if (const auto word = name.Word()) read(*word);
  } catch (const FileError& error) {
    report_.Error(name.What(), ": " + error.message, error.hint);
  } catch (SceneError& error) {
    report_.ErrorIn(name.What(), std::move(error));
  }
}

std::shared_ptr<const Texture> ObjectReader::Image(const Field& name, Assets::Use use) {
  std::shared_ptr<const Texture> image;
  WithFile(name, [&](const std::string& word) { image = assets_.Image(word, report_.Source().Source().name, use); });
  return image;
}

std::shared_ptr<const Environment> ObjectReader::EnvironmentNamed(const Field& name) {
  std::shared_ptr<const Environment> environment;
  WithFile(name, [&](const std::string& word) {
    environment = assets_.EnvironmentNamed(word, report_.Source().Source().name);
  });
  return environment;
}

Assets::BoxedMesh ObjectReader::MeshNamed(const Field& name, const Assets::Shading& shading) {
  Assets::BoxedMesh boxed;
  WithFile(name, [&](const std::string& word) {
    boxed = assets_.Mesh(WithExtension(word), report_.Source().Source().name, shading);
  });
  return boxed;
}

std::shared_ptr<const Assets::Model> ObjectReader::ModelNamed(const Field& name, const Assets::Shading& shading) {
  std::shared_ptr<const Assets::Model> model;
  WithFile(name, [&](const std::string& word) {
    model = assets_.ModelNamed(WithExtension(word), report_.Source().Source().name, shading);
  });
  return model;
}

Scene ObjectReader::Finish() {
  auto& files = builder_.scene.files;
  files.insert(files.end(), assets_.FilesRead().begin(), assets_.FilesRead().end());
  return builder_.Finish();
}

}  // namespace ray
