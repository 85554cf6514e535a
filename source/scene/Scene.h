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

/// A setting in a scene file: the name of the option that overrides it, without the dash, and its value as on the
/// command line. Stored as text, so that a scene does not depend on what it sets.
struct SceneSetting {
  std::string option, value;  // "max_depth", "2"
  std::string origin;         // the source of the setting: "room.yaml:12", or a course whose rule it is
};

/// The scene as described by its file. Never changes after parsing.
struct Scene {
  Node root;                                    // identity transform; its bounds are the scene's, in world coordinates
  std::vector<Material> materials{Material{}};  // 0 is the default, for nodes with none to inherit
  std::vector<std::unique_ptr<const Light>> lights;
  Camera camera;
  R2::Color background, ambient;
  std::shared_ptr<const Environment> environment;  // replaces the background, and is a light; null for none
  bool has_default_camera = false, has_default_lights = false;  // the file names none
  bool is_mirrored = false;  // the file's world is left-handed: z here is the negative of the file's
  double shadow_bias = 0;  // the minimum distance of a hit of a shadow ray or a reflection
  std::vector<SceneSetting> settings;
  std::vector<std::string> files;  // the files read: scene files, the top one first, then meshes and textures
};

/// Returns the scene's lights that are not black.
inline std::vector<const Light*> LightsOf(const Scene& scene) {
  std::vector<const Light*> lights;
  for (const auto& light : scene.lights)
    if (!light->IsBlack()) lights.push_back(light.get());
  return lights;
}

}  // namespace ray
