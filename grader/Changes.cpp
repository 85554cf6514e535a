#include "grader/Changes.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace ray::grade {
namespace {

/// Visits parents before children, with a stack, since graphs may be deep.
template <typename Visit>
std::vector<Node*> InOrder(Node& root, const Visit& visit) {
  std::vector<Node*> all, open{&root};
  while (!open.empty()) {
    Node* node = open.back();
    open.pop_back();
    visit(*node);
    all.push_back(node);
    for (Node& child : node->children) open.push_back(&child);
  }
  return all;
}

void FindBounds(Node& root) {
  const std::vector<Node*> all = InOrder(root, [](Node&) {});
  for (auto node = all.rbegin(); node != all.rend(); ++node) SetBounds(**node);
}

// Without recursion, since graphs may be deep.
Node Copied(const Node& root) {
  struct Open {
    const Node& from;
    Node& to;
  };
  Node copy;
  std::vector<Open> open{{root, copy}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    const auto& [motion, transform, shape, line, material, operation, bounds, location, children] = from;
    to.motion = motion;
    to.transform = transform;
    to.shape = shape;
    if (line) to.line = std::make_unique<const R3::Segment>(*line);
    to.material = material;
    to.operation = operation;
    to.bounds = bounds;
    to.location = location;
    to.children.resize(children.size());
    for (std::size_t i = 0; i < children.size(); ++i) open.push_back({children[i], to.children[i]});
  }
  return copy;
}

std::unique_ptr<const Light> Made(const R3::Recipe& recipe) {
  return FindLightKind(recipe.kind)->make(recipe.arguments);
}

R3::Matrix Product(const R3::Matrix& a, const R3::Matrix& b) {
  R3::Matrix product;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      product.m[i][j] = j == 3 ? a.m[i][3] : 0;
      for (std::size_t k = 0; k < 3; ++k) product.m[i][j] += a.m[i][k] * b.m[k][j];
    }
  return product;
}

/// A leaf with all properties that it inherits.
struct Leaf {
  Node* node;
  R3::Matrix reversed;
  int material;
};

std::vector<Leaf> LeavesOf(Node& root) {
  std::vector<Leaf> leaves, open{{&root, {}, Node::inherit}};
  while (!open.empty()) {
    Leaf at = open.back();
    open.pop_back();
    if (at.node->material != Node::inherit) at.material = at.node->material;
    at.reversed = Product(at.node->transform, at.reversed);
    if (at.node->shape) {
      leaves.push_back(at);
      continue;
    }
    for (auto child = at.node->children.rbegin(); child != at.node->children.rend(); ++child)
      open.push_back({&*child, at.reversed, at.material});
  }
  return leaves;
}

}  // namespace

// Lists the names of all members, so that a new one must be copied as well.
Scene Copied(const Scene& scene) {
  const auto& [root, materials, lights, camera, background, ambient, environment, has_default_camera,
               has_default_lights, is_mirrored, shadow_bias, settings, files] = scene;
  std::vector<std::unique_ptr<const Light>> same_lights;
  for (const auto& light : lights) same_lights.push_back(Made(light->MadeFrom()));
  return {Copied(root), materials,          std::move(same_lights), camera,      background,  ambient,
          environment,  has_default_camera, has_default_lights,     is_mirrored, shadow_bias, settings,
          files};
}

void ChangeMaterials(Scene& scene, const std::function<void(Material&)>& change) {
  for (Material& material : scene.materials) change(material);
}

double* LightArguments::At(const std::string& name) {
  const LightKind& of_kind = *FindLightKind(kind);
  for (std::size_t i = 0; i < of_kind.arguments.size(); ++i)
    if (name == of_kind.arguments[i].name) return &recipe.arguments[i];
  return nullptr;
}

void ChangeLights(Scene& scene, const std::function<void(LightArguments&)>& change) {
  for (auto& light : scene.lights) {
    R3::Recipe recipe = light->MadeFrom();
    LightArguments arguments{recipe.kind, recipe};
    change(arguments);
    light = Made(recipe);
  }
}

void ChangeTransforms(Scene& scene, const std::function<R3::Matrix(const R3::Matrix&)>& change) {
  InOrder(scene.root, [&](Node& node) {
    if (!IsIdentity(node.transform)) node.transform = change(node.transform);
  });
  FindBounds(scene.root);
}

void IgnoreNestedTransforms(Scene& scene) {
  std::vector<std::pair<Node*, bool>> open{{&scene.root, false}};
  while (!open.empty()) {
    auto [node, is_nested] = open.back();
    open.pop_back();
    if (is_nested) node->transform = {};
    is_nested = is_nested || !IsIdentity(node->transform);
    for (Node& child : node->children) open.emplace_back(&child, is_nested);
  }
  FindBounds(scene.root);
}

void KeepInnermostTransforms(Scene& scene) {
  std::vector<std::pair<Node*, R3::Matrix>> open{{&scene.root, {}}};
  while (!open.empty()) {
    auto [node, above] = open.back();
    open.pop_back();
    if (!IsIdentity(node->transform)) {
      const R3::Matrix own = node->transform;
      const auto placed = R3::Transform::Of(above);
      if (placed) node->transform = Product(placed->Inverse(), own);
      above = own;
    }
    for (Node& child : node->children) open.emplace_back(&child, above);
  }
  FindBounds(scene.root);
}

void ChangeInheritedMaterials(Scene& scene, const std::function<int(int last)>& material) {
  struct Open {
    Node* node;
    bool inherits;  // a material of a group
  };
  int last = Node::inherit;
  std::vector<Open> open{{&scene.root, false}};
  while (!open.empty()) {
    const auto [node, inherits] = open.back();
    open.pop_back();
    const bool has_own = node->material != Node::inherit;
    if (has_own) last = node->material;
    if (node->shape && !has_own && inherits) node->material = material(last);
    for (auto child = node->children.rbegin(); child != node->children.rend(); ++child)
      open.push_back({&*child, inherits || has_own});
  }
}

void CountMaterialsFromOne(Scene& scene) {
  constexpr int default_material = 0;
  InOrder(scene.root, [](Node& node) {
    if (node.material > default_material) --node.material;
  });
}

void RemoveBacks(Scene& scene, const std::function<bool(const R3::Shape&)>& is_lost) {
  constexpr std::size_t default_material = 0;
  for (const Leaf& leaf : LeavesOf(scene.root)) {
    if (!is_lost(*leaf.node->shape)) continue;
    Material one_sided =
        scene.materials[leaf.material == Node::inherit ? default_material : static_cast<std::size_t>(leaf.material)];
    one_sided.one_sided = true;
    leaf.node->material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(std::move(one_sided));
  }
}

void PutPolesAlongY(Scene& scene) {
  for (Node* node : InOrder(scene.root, [](Node&) {})) {
    const auto sphere = node->shape ? node->shape->AsSphere() : std::nullopt;
    if (!sphere) continue;
    // y and z are exchanged about the center.
    const double between = sphere->center.y - sphere->center.z;
    Node ball;
    ball.shape = node->shape;
    ball.location = node->location;
    node->shape.reset();
    node->transform.m = {{{1, 0, 0, 0}, {0, 0, 1, between}, {0, 1, 0, -between}}};
    node->children.push_back(std::move(ball));
  }
  FindBounds(scene.root);
}

void ChangeTextures(Scene& scene, const std::function<R2::Image(const R2::Image&)>& change) {
  for (Material& material : scene.materials)
    if (material.texture) material.texture = std::make_shared<Texture>(Texture{change(material.texture->image)});
}

void ReverseTransforms(Scene& scene) {
  std::vector<Node> groups;
  for (const Leaf& leaf : LeavesOf(scene.root)) {
    Node group;
    group.transform = leaf.reversed;
    group.material = leaf.material;
    group.location = leaf.node->location;
    group.children.push_back(std::move(*leaf.node));
    groups.push_back(std::move(group));
  }
  scene.root.transform = {};
  scene.root.children = std::move(groups);
  FindBounds(scene.root);
}

void RemoveShapes(Scene& scene, const std::function<bool(const R3::Shape&)>& is_lost) {
  InOrder(scene.root, [&](Node& node) {
    std::erase_if(node.children, [&](const Node& child) { return child.shape && is_lost(*child.shape); });
  });
  FindBounds(scene.root);
}

R2::Image EachColor(const R2::Image& image, const std::function<R2::Color(const R2::Color&)>& change) {
  R2::Image changed(image.Width(), image.Height());
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) changed.Set(x, y, change(image.At(x, y)));
  return changed;
}

R2::Image EachChannel(const R2::Image& image, double (*change)(double)) {
  return EachColor(image, [&](const R2::Color& c) { return R2::Color{change(c.r), change(c.g), change(c.b)}; });
}

R2::Image Moved(const R2::Image& image, int width, int height, const std::function<PixelPlace(int x, int y)>& from) {
  R2::Image moved(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto [column, row] = from(x, y);
      moved.Set(x, y, image.At(std::clamp(column, 0, image.Width() - 1), std::clamp(row, 0, image.Height() - 1)));
    }
  return moved;
}

}  // namespace ray::grade
