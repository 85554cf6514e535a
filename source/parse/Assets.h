#pragma once

#include <compare>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "R3/Mesh.h"
#include "source/parse/Files.h"
#include "source/parse/Parse.h"
#include "source/parse/SceneError.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/scene/Environment.h"
#include "source/scene/Material.h"
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
    bool has_look = false;  // the file says materials, textures or colors
  };
  /// Where the normals come from that a mesh is shaded with.
  struct Shading {
    enum class Normals {
      of_triangles,       // flat
      of_file,            // where it has any
      of_file_or_groups,  // or of its smoothing groups
      wanted,             // the same, and a warning where it has neither
      by_angle            // made anew
    };
    Normals normals = Normals::of_triangles;
    double degrees = 0;  // by_angle: up to which triangles are smoothed

    friend auto operator<=>(const Shading&, const Shading&) = default;
  };

  /// Throws FileError when the naming word is to blame, SceneError for a place in the mesh file. A file that failed
  /// before gives a null mesh: once reported is enough.
  BoxedMesh Mesh(const std::string& name, const std::string& named_in, const Shading& shading);
  /// A mesh whose file is found already.
  BoxedMesh MeshOf(const FoundFile& file, const Shading& shading);

  /// A mesh cut by the materials that its file says.
  struct Model {
    struct Part {
      BoxedMesh mesh;
      std::optional<std::size_t> material;  // index into `materials`; nothing where the file says none
    };
    std::vector<Material> materials;
    std::vector<Part> parts;
  };
  /// Throws as Mesh does; null when the file failed before.
  std::shared_ptr<const Model> ModelNamed(const std::string& name, const std::string& named_in, const Shading& shading);
  std::shared_ptr<const Model> ModelOf(const FoundFile& file, const Shading& shading);

  /// A file beside another, or in the current folder. Throws FileError.
  FoundFile Find(const std::string& name, const std::string& named_in) const { return files_.Find(name, named_in); }
  /// Its bytes; it then counts as read. Throws FileError.
  std::string Read(const FoundFile& file);

  /// From now on 8-bit colors are sRGB. False, and nothing done, where images or meshes were read otherwise before.
  bool DecodeSrgb();

  /// What a picture's values are: colors, which a linear workflow decodes from 8 bits, or numbers, which it does not.
  enum class Use { color, data };
  /// Throws FileError; null when the file failed before.
  std::shared_ptr<const Texture> Image(const std::string& name, const std::string& named_in, Use use);

  /// Light from all around. Throws FileError; null when the file failed before, or the options name another
  /// environment: then the file is found and not decoded.
  std::shared_ptr<const Environment> EnvironmentNamed(const std::string& name, const std::string& named_in);
  /// Loads the file at the top of `files`, which the user named and which may lie anywhere. Throws FileError.
  std::shared_ptr<const Environment> EnvironmentAtTop(const Files& files);

  /// The files read so far, as they are shown to the user.
  const std::set<std::string>& FilesRead() const { return files_read_; }

 private:
  std::shared_ptr<const Environment> EnvironmentOf(const FoundFile& file, const std::string& bytes);
  MeshFile ReadMesh(const FoundFile& file, const Shading& shading);
  void WarnOfMesh(const FoundFile& file, std::size_t triangles, int dropped);
  R2::Image DecodeImage(const FoundFile& file, const std::string& bytes, Use use);

  const Files& files_;
  Report& report_;
  bool decode_srgb_;
  bool environment_is_replaced_;
  std::int64_t max_texture_bytes_;
  std::map<std::pair<std::string, Shading>, BoxedMesh> meshes_;
  std::map<std::pair<std::string, Shading>, std::shared_ptr<const Model>> models_;
  std::map<std::pair<std::string, Use>, std::shared_ptr<const Texture>> images_;
  std::map<std::string, std::shared_ptr<const Environment>> environments_;
  std::int64_t texels_ = 0;
  std::set<std::string> files_read_;
};

}  // namespace ray
