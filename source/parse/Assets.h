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

  /// A mesh and the box around it, whose computation visits all triangles.
  struct BoxedMesh {
    std::shared_ptr<const R3::Mesh> mesh;
    R3::Box bounds;
    bool has_look = false;  // the file has materials, textures or colors
  };
  /// The source of the normals for shading a mesh.
  struct Shading {
    enum class Normals {
      of_triangles,       // flat
      of_file,            // if it has any
      of_file_or_groups,  // or those of its smoothing groups
      wanted,             // the same, with a warning if it has neither
      by_angle            // computed
    };
    Normals normals = Normals::of_triangles;
    double degrees = 0;  // by_angle: the largest angle between triangles that are smoothed

    friend auto operator<=>(const Shading&, const Shading&) = default;
  };

  /// Returns a mesh. Throws FileError if the name is at fault, SceneError for a mistake in the mesh file. If the file
  /// failed before, returns a null mesh, since one report is enough.
  BoxedMesh Mesh(const std::string& name, const std::string& named_in, const Shading& shading);
  /// Returns the mesh of a file that was already found.
  BoxedMesh MeshOf(const FoundFile& file, const Shading& shading);

  /// A mesh split by the materials that its file states.
  struct Model {
    struct Part {
      BoxedMesh mesh;
      std::optional<std::size_t> material;  // index into `materials`; std::nullopt if the file states none
    };
    std::vector<Material> materials;
    std::vector<Part> parts;
  };
  /// Returns a model. Throws like Mesh; null if the file failed before.
  std::shared_ptr<const Model> ModelNamed(const std::string& name, const std::string& named_in, const Shading& shading);
  std::shared_ptr<const Model> ModelOf(const FoundFile& file, const Shading& shading);

  /// Finds a file next to another, or in the current folder. Throws FileError.
  FoundFile Find(const std::string& name, const std::string& named_in) const { return files_.Find(name, named_in); }
  /// Returns its bytes; it then counts as read. Throws FileError.
  std::string Read(const FoundFile& file);

  /// Interprets 8-bit colors as sRGB from now on. Returns false, without effect, if images or meshes were already read
  /// otherwise.
  bool DecodeSrgb();

  /// The meaning of an image's values: colors, which a linear workflow decodes from 8 bits, or data, which it does not.
  enum class Use { color, data };
  /// Returns a texture. Throws FileError; null if the file failed before.
  std::shared_ptr<const Texture> Image(const std::string& name, const std::string& named_in, Use use);

  /// Returns an environment. Throws FileError; null if the file failed before, or if the options name another
  /// environment: then the file is found but not decoded.
  std::shared_ptr<const Environment> EnvironmentNamed(const std::string& name, const std::string& named_in);
  /// Loads the file at the top of `files`, which the user named and which may be anywhere. Throws FileError.
  std::shared_ptr<const Environment> EnvironmentAtTop(const Files& files);

  /// Returns the files read so far, as shown to the user.
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
