#pragma once

#include <memory>
#include <string>
#include <vector>

#include "R2/Color.h"
#include "source/scene/Camera.h"
#include "source/scene/Environment.h"
#include "source/scene/Light.h"
#include "source/scene/Material.h"
#include "source/scene/Node.h"

namespace ray {

/// What was asked for. Never changes after parsing.
struct Scene {
  Node root;                                    // identity transform; its bounds are the scene's, in world coordinates
  std::vector<Material> materials{Material{}};  // 0 is the default, for nodes that inherit from nobody
  std::vector<std::unique_ptr<const Light>> lights;
  Camera camera;
  R2::Color background, ambient;
  std::shared_ptr<const Environment> environment;  // seen instead of the background, and a light; null for none
  std::vector<std::string> files;  // what it was read from: scene files, the top one first, then meshes and textures
};

}  // namespace ray
