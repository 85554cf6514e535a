#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "R3/Mesh.h"
#include "source/parse/Files.h"
#include "source/parse/Report.h"
#include "source/scene/Texture.h"

namespace ray {

/// The meshes and textures that a scene names. Each file is read once, however often and by whatever name it is used.
class Assets {
 public:
  Assets(const Files& files, Report& report, bool decode_srgb)
      : files_(files), report_(report), decode_srgb_(decode_srgb) {}

  /// A mesh and the box around it, which costs a walk over all triangles.
  struct BoxedMesh {
    std::shared_ptr<const R3::Mesh> mesh;
    R3::Box bounds;
  };

  /// Throws FileError when the naming word is to blame, SceneError for a place in the mesh file. A file that failed
  /// before gives a null mesh: once reported is enough.
  BoxedMesh Mesh(const std::string& name, const std::string& named_in, bool smooth);
  /// Throws FileError; null when the file failed before.
  std::shared_ptr<const Texture> Image(const std::string& name, const std::string& named_in);

  /// The files read so far, as they are shown to the user.
  const std::set<std::string>& FilesRead() const { return files_read_; }

 private:
  std::string Read(const FoundFile& file);
  BoxedMesh ReadMesh(const FoundFile& file, bool smooth);
  std::shared_ptr<const Texture> ReadImage(const FoundFile& file);

  const Files& files_;
  Report& report_;
  bool decode_srgb_;
  std::map<std::pair<std::filesystem::path, bool>, BoxedMesh> meshes_;
  std::map<std::filesystem::path, std::shared_ptr<const Texture>> images_;
  std::int64_t texels_ = 0;
  std::set<std::string> files_read_;
};

}  // namespace ray
