#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "R3/Mesh.h"
#include "source/scene/Scene.h"

namespace ray {

/// A scene as a .scn file. Read again it is the same scene: every number is the same to the bit, so that pictures are.
/// Settings of the command line are not in it, only those of Scene::settings.
struct ScnText {
  struct Mesh {
    std::string name, text;  // a Wavefront OBJ file
  };

  std::string text;
  std::vector<Mesh> meshes;             // that came from no file; the text names them as files beside it
  std::set<std::string> other_folders;  // where files lie that the text names and that are not below its own folder
  std::vector<std::string> warnings;    // what the language cannot say
};

///   file   that the text is meant for, absolute and free of links: files of meshes and pictures are named as seen from
///          its folder, and meshes without a file get names that begin like its own
ScnText WriteScn(const Scene& scene, const std::filesystem::path& file);

/// A mesh as a Wavefront OBJ file. Read again, smooth if it is smooth, it is the same mesh to the bit.
std::string ObjText(const R3::Mesh& mesh);

}  // namespace ray
