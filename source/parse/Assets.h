#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "R3/Mesh.h"
#include "source/parse/Files.h"
#include "source/parse/Parse.h"
#include "source/parse/Report.h"
#include "source/scene/Environment.h"
#include "source/scene/Texture.h"

namespace ray {

/// The meshes, textures and environments that a scene names. Each file is read once, however often and by whatever name
/// it is used.
class Assets {
 public:
  Assets(const Files& files, Report& report, const ParseOptions& options)
      : files_(files),
        report_(report),
        decode_srgb_(options.decode_srgb),
        environment_is_replaced_(!options.environment.empty()),
        max_texture_bytes_(options.max_texture_bytes) {}

  /// A mesh and the box around it, which costs a walk over all triangles.
  struct BoxedMesh {
    std::shared_ptr<const R3::Mesh> mesh;
    R3::Box bounds;
  };

  /// Throws FileError when the naming word is to blame, SceneError for a place in the mesh file. A file that failed
  /// before gives a null mesh: once reported is enough.
  BoxedMesh Mesh(const std::string& name, const std::string& named_in, bool smooth);
  /// The same of a file that is found already, smooth where it can be.
  BoxedMesh MeshOf(const FoundFile& file) { return MeshOf(file, Normals::if_any); }
  /// What a picture's values are: colors, which a linear workflow decodes from 8 bits, or numbers, which it does not.
  enum class Use { color, data };
  /// Throws FileError; null when the file failed before.
  std::shared_ptr<const Texture> Image(const std::string& name, const std::string& named_in, Use use);

  /// Light from all around. Throws FileError; null when the file failed before, or the options name another
  /// environment: then the file is found and not decoded.
  std::shared_ptr<const Environment> EnvironmentNamed(const std::string& name, const std::string& named_in);
  /// Of the file at the top of `files`, which the user named and which may lie anywhere. Throws FileError.
  std::shared_ptr<const Environment> EnvironmentAtTop(const Files& files);

  /// The files read so far, as they are shown to the user.
  const std::set<std::string>& FilesRead() const { return files_read_; }

 private:
  std::string Read(const FoundFile& file);
  std::shared_ptr<const Environment> EnvironmentOf(const FoundFile& file, const std::string& bytes);
  /// Whether the normals that a file brings are to be used, and their absence is worth a warning.
  enum class Normals { unused, if_any, wanted };
  BoxedMesh MeshOf(const FoundFile& file, Normals use);
  BoxedMesh ReadMesh(const FoundFile& file, Normals use);
  R2::Image DecodeImage(const FoundFile& file, const std::string& bytes, Use use);

  const Files& files_;
  Report& report_;
  bool decode_srgb_;
  bool environment_is_replaced_;
  std::int64_t max_texture_bytes_;
  std::map<std::pair<std::string, Normals>, BoxedMesh> meshes_;
  std::map<std::pair<std::string, Use>, std::shared_ptr<const Texture>> images_;
  std::map<std::string, std::shared_ptr<const Environment>> environments_;
  std::int64_t texels_ = 0;
  std::set<std::string> files_read_;
};

}  // namespace ray
