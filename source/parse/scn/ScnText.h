#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "R3/Mesh.h"
#include "source/scene/Scene.h"

namespace ray {

/// A scene as a .scn file. Reading it gives the same scene: every number is bit-identical, and therefore images are.
/// Settings of the command line are not included, only those of Scene::settings.
struct ScnText {
  struct Mesh {
    std::string name, text;  // a Wavefront OBJ file
  };

  std::string text;
  std::vector<Mesh> meshes;             // those without a file; the text names them as files next to it
  std::set<std::string> other_folders;  // folders of files that the text names and that are not below its own folder
  std::vector<std::string> warnings;    // parts that the language cannot express
};

///   file   the destination of the text, absolute and without links: mesh and image files are named relative to its
///          folder, and meshes without a file get names that begin like its own
ScnText WriteScn(const Scene& scene, const std::filesystem::path& file);

/// Returns a mesh as a Wavefront OBJ file. Reading it, with smooth shading if it is smooth, gives a bit-identical mesh.
std::string ObjText(const R3::Mesh& mesh);

}  // namespace ray
