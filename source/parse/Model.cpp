#include "source/parse/Model.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>

#include "R3/Box.h"
#include "source/parse/Text.h"
#include "source/parse/meshes/Faces.h"
#include "source/parse/meshes/Mtl.h"
#include "source/text/Words.h"

namespace ray {
namespace {

constexpr R2::Color white{1, 1, 1};

/// The height of a bump map with multiplier 1, as a share of the extent of the whole file: the format defines no unit.
constexpr double bump_height = 0.01;

/// A material of a library, and the library.
struct LibraryMaterial {
  MtlMaterial material;
  std::string library;  // its name in messages; images are searched next to it
};

/// Removes what looks like a comment after a name; it may also be part of the name: "Material #25".
std::string WithoutComment(const std::string& name) {
  std::size_t hash = name.find('#');
  while (hash != std::string::npos && (hash == 0 || !IsSpace(name[hash - 1]))) hash = name.find('#', hash + 1);
  return hash == std::string::npos ? name : name.substr(0, name.find_last_not_of(" \t", hash - 1) + 1);
}

/// Returns true if the material is meant to be opaque. Illumination models 0 to 3, 5 and 8 have no transparency, but
/// programs for photogrammetry, and MeshLab before 2023, write Tr 1 with them for opaque materials.
bool MeansOpaque(const MtlMaterial& m) {
  const int illum = m.illum.value_or(2);
  return !m.d && m.Tr.value_or(0) >= 1 && (illum <= 3 || illum == 5 || illum == 8);
}

/// Returns the opacity, 1 for opaque. Programs that write both d and Tr mean d.
double OpacityOf(const MtlMaterial& m) {
  if (MeansOpaque(m)) return 1;
  if (m.d) return std::min(1.0, *m.d);
  return m.Tr ? 1 - std::min(1.0, *m.Tr) : 1;
}

/// Returns the transmitted share of the light from behind. Programs write Tf for opaque materials too.
R2::Color Transmission(const MtlMaterial& m, bool is_refractive) {
  const double opacity = OpacityOf(m);
  if (is_refractive && m.Tf && opacity == 1) return *m.Tf;
  return (1 - opacity) * m.Tf.value_or(white);
}

/// Converts the numbers of a material as described in docs/meshes.md.
Material WithoutImages(const MtlMaterial& m) {
  const int illum = m.illum.value_or(2);
  const bool has_highlights = illum >= 2 && m.Ns.value_or(0) > 0, has_mirror = illum >= 3 && illum != 10;
  const bool is_refractive = illum == 6 || illum == 7;
  Material material = DiffuseMaterial(m.Kd.value_or(m.map_Kd ? white : default_gray));
  // Programs without ambient colors write white, whatever the material is.
  if (m.Ka && *m.Ka != white) material.ka = *m.Ka;
  if (has_highlights) material.ks = m.Ks.value_or(R2::Color{});
  if (has_mirror) material.kr = m.Ks.value_or(R2::Color{});
  material.n = m.Ns.value_or(1);
  material.emission = m.Ke.value_or(R2::Color{});
  material.kt = Transmission(m, is_refractive);
  material.kd = OpacityOf(m) * material.kd;
  if (is_refractive && m.Ni.value_or(0) > 0) material.ir = *m.Ni;
  return material;
}

bool IsGray(const R2::Image& image) {
  const R2::Image::Floats& c = image.Channels();
  for (std::size_t i = 0; i + 2 < c.size(); i += 3)
    if (c[i] != c[i + 1] || c[i] != c[i + 2]) return false;
  return true;
}

/// The materials that a mesh names, read from its libraries.
class MaterialMaker {
 public:
  MaterialMaker(const MeshFile& mesh, const FoundFile& file, Assets& assets, Report& report)
      : file_(file), assets_(assets), report_(report) {
    R3::Box box;
    for (const R3::Point& p : mesh.data.positions) box.Extend(p);
    extent_ = box.IsEmpty() ? 0 : MaxComponent(box.Size());
    for (const MeshName& names : mesh.material_files) ReadLibraries(names);
    for (const auto& [name, material] : known_) by_plain_name_.try_emplace(WithoutComment(name), &material);
  }

  /// Returns the material with that name in the libraries, or null.
  const LibraryMaterial* Find(const MeshName& name) const {
    for (const std::string& wanted : {name.name, WithoutComment(name.name)})
      if (const auto found = known_.find(wanted); found != known_.end()) return &found->second;
    const auto same = by_plain_name_.find(WithoutComment(name.name));
    if (same != by_plain_name_.end()) return same->second;
    const bool means_none = name.name.empty() || name.name == "None" || name.name == "(null)";
    if (!means_none && is_complete_) WarnOfUnknown(name);
    return nullptr;
  }

  Material Make(const LibraryMaterial& known) {
    const MtlMaterial& m = known.material;
    Material material = WithoutImages(m);
    if (MeansOpaque(m))
      report_.Warn(m.place, "Tr 1 counts as opaque: illum 0 to 3, 5 and 8 have no transparency");
    else if (OpacityOf(m) == 0 && material.kt == white && IsBlack(material.ks) && IsBlack(material.kr))
      report_.Warn(m.place, "material " + Quoted(m.name) + " is invisible: its opacity is 0");
    if (m.map_Kd) material.texture = Image(*m.map_Kd, known.library, Assets::Use::color);
    if (m.norm) material.normal_map = Image(*m.norm, known.library, Assets::Use::data);
    if (m.bump) AddBump(*m.bump, known.library, material);
    return material;
  }

  std::shared_ptr<const Texture> Image(const MtlMap& map, const std::string& named_in, Assets::Use use) {
    try {
      return assets_.Image(PathOf(map.file, named_in), named_in, use);
    } catch (const FileError& error) {
      report_.Warn(map.place,
                   error.message + "; the material does not use it" + (error.hint.empty() ? "" : "; " + error.hint));
      return nullptr;
    }
  }

 private:
  bool IsThere(const std::string& name, const std::string& named_in) const {
    try {
      assets_.Find(name, named_in);
      return true;
    } catch (const FileError&) {
      return false;
    }
  }

  /// Returns the first existing spelling of a file's name: unchanged, without a trailing comment, or with the
  /// backslashes of Windows replaced. Returns the name itself if none exists.
  std::string PathOf(const std::string& name, const std::string& named_in) const {
    for (std::string path : {name, WithoutComment(name)}) {
      if (IsThere(path, named_in)) return path;
      std::ranges::replace(path, '\\', '/');
      if (IsThere(path, named_in)) return path;
    }
    return name;
  }

  /// Reads one library, whose name may contain blanks, or several. Exporters repeat the statement before each object.
  void ReadLibraries(const MeshName& names) {
    if (!statements_.insert(names.name).second) return;
    const std::string whole = PathOf(names.name, file_.shown);
    if (IsThere(whole, file_.shown)) return ReadLibrary(whole, names.place);
    for (const std::string& name : SplitWords(WithoutComment(names.name)))
      ReadLibrary(PathOf(name, file_.shown), names.place);
  }

  void ReadLibrary(const std::string& name, const std::string& place) {
    try {
      ReadLibrary(assets_.Find(name, file_.shown));
    } catch (const FileError& error) {
      report_.Warn(place, error.message + "; its materials are gray" + (error.hint.empty() ? "" : "; " + error.hint));
      is_complete_ = false;
    }
  }

  void ReadLibrary(const FoundFile& file) {
    if (!libraries_.insert(file.canonical).second) return;
    const Text text{file.shown, assets_.Read(file)};
    for (MtlMaterial& material : ReadMtl(text, report_)) {
      const std::string name = material.name, place = material.place;
      const bool is_new = known_.insert_or_assign(name, LibraryMaterial{std::move(material), file.shown}).second;
      if (!is_new) report_.Warn(place, "material " + Quoted(name) + " is defined again; the last definition is used");
    }
  }

  /// Suggests a known name only for the first few: each suggestion takes time that grows with the library.
  void WarnOfUnknown(const MeshName& name) const {
    constexpr int most_suggestions = 10;
    std::vector<std::string> names;
    if (unknown_++ < most_suggestions)
      for (const auto& [known, material] : known_) names.push_back(known);
    report_.Warn(name.place,
                 "unknown material " + Quoted(name.name) + "; its faces are gray" + DidYouMean(name.name, names));
  }

  /// Adds a bump map. Some programs write normal maps under that name; heights are gray.
  void AddBump(const MtlMap& map, const std::string& library, Material& material) {
    const auto image = Image(map, library, Assets::Use::data);
    if (!image) return;
    if (IsGray(image->image)) {
      material.bump = image;
      material.bump_height = map.multiplier * bump_height * extent_;
    } else if (!material.normal_map) {
      report_.Warn(map.place, Quoted(map.file) + " is not gray; using it as a normal map");
      material.normal_map = image;
    }
  }

  const FoundFile& file_;
  Assets& assets_;
  Report& report_;
  double extent_ = 0;
  std::map<std::string, LibraryMaterial> known_;
  std::map<std::string, const LibraryMaterial*> by_plain_name_;  // without possible comments
  std::set<std::string> statements_, libraries_;                 // already seen; libraries by their canonical paths
  bool is_complete_ = true;                                      // every library was found
  mutable int unknown_ = 0;
};

/// Makes meshes of subsets of another mesh's triangles, with the vertices that these use.
class Cutter {
 public:
  explicit Cutter(const R3::MeshData& data) : data_(data), new_names_(data.positions.size(), Corner::none) {}

  /// Extracts some triangles in time proportional to their number rather than that of the whole mesh, which may have
  /// thousands of parts.
  R3::MeshData Cut(std::span<const std::uint32_t> triangles) {
    part_ = {};
    for (const std::uint32_t t : triangles) {
      auto triangle = data_.triangles[t];
      for (std::uint32_t& name : triangle) name = NewName(name);
      part_.triangles.push_back(triangle);
      if (!data_.lines.empty()) part_.lines.push_back(data_.lines[t]);
    }
    for (const std::uint32_t t : triangles)
      for (const std::uint32_t name : data_.triangles[t]) new_names_[name] = Corner::none;
    return std::move(part_);
  }

 private:
  std::uint32_t NewName(std::uint32_t name) {
    std::uint32_t& new_name = new_names_[name];
    if (new_name != Corner::none) return new_name;
    new_name = static_cast<std::uint32_t>(part_.positions.size());
    part_.positions.push_back(data_.positions[name]);
    if (!data_.normals.empty()) part_.normals.push_back(data_.normals[name]);
    if (!data_.uvs.empty()) part_.uvs.push_back(data_.uvs[name]);
    if (!data_.colors.empty()) part_.colors.push_back(data_.colors[name]);
    return new_name;
  }

  const R3::MeshData& data_;
  std::vector<std::uint32_t> new_names_;
  R3::MeshData part_;
};

/// The triangles of each material, in the order of first use.
std::vector<std::pair<std::uint32_t, std::vector<std::uint32_t>>> TrianglesByMaterial(const MeshFile& mesh) {
  std::vector<std::pair<std::uint32_t, std::vector<std::uint32_t>>> groups;
  std::unordered_map<std::uint32_t, std::size_t> number_of;
  const std::vector<std::uint32_t> materials =
      ValuesOfTriangles(mesh.material_runs, mesh.data.triangles.size(), MeshFile::no_material);
  for (std::uint32_t t = 0; t < materials.size(); ++t) {
    const auto [known, is_new] = number_of.try_emplace(materials[t], groups.size());
    if (is_new) groups.push_back({materials[t], {}});
    groups[known->second].second.push_back(t);
  }
  return groups;
}

/// Transforms the texture coordinates of a part as its material states.
void MapTexture(const MtlMap& map, ModelData::Part& part, Report& report) {
  const bool moves = map.scale.x != 1 || map.scale.y != 1 || map.offset.x != 0 || map.offset.y != 0;
  part.is_whole = part.is_whole && !moves;
  for (R2::Point& uv : part.data.uvs)
    if (moves) uv = {uv.x * map.scale.x + map.offset.x, uv.y * map.scale.y + map.offset.y};
  const auto is_inside = [](const R2::Point& uv) { return uv.x >= 0 && uv.x <= 1 && uv.y >= 0 && uv.y <= 1; };
  if (map.is_clamped && !std::ranges::all_of(part.data.uvs, is_inside))
    report.Warn(map.place, "'-clamp on' is not supported: the texture repeats");
}

/// Returns the material given by vertex colors and a texture without a material; std::nullopt if there are neither.
std::optional<Material> LookWithoutMaterial(const MeshFile& mesh, bool has_colors, const FoundFile& file,
                                            MaterialMaker& maker, Report& report) {
  if (!has_colors && mesh.textures.empty()) return {};
  Material material = DiffuseMaterial(white);
  if (mesh.textures.empty()) return material;
  const MeshName& image = mesh.textures.front();
  material.texture = maker.Image({.file = image.name, .place = image.place}, file.shown, Assets::Use::color);
  if (mesh.textures.size() > 1)
    report.Warn(mesh.textures[1].place,
                "only the first of " + std::to_string(mesh.textures.size()) + " textures is used");
  return material;
}

}  // namespace

Material DiffuseMaterial(const R2::Color& kd) {
  Material material;
  material.ka = material.kd = kd;
  material.ks = material.kr = {0, 0, 0};
  material.texture_multiplies_ka = true;
  return material;
}

ModelData CutByMaterial(MeshFile mesh, const FoundFile& file, Assets& assets, Report& report) {
  ModelData model;
  MaterialMaker maker(mesh, file, assets, report);
  const auto groups = TrianglesByMaterial(mesh);
  const bool has_colors = !mesh.data.colors.empty();
  Cutter cutter(mesh.data);
  for (const auto& [number, triangles] : groups) {
    ModelData::Part part;
    part.is_whole = groups.size() == 1;
    part.data = part.is_whole ? std::move(mesh.data) : cutter.Cut(triangles);
    const auto* known = number == MeshFile::no_material ? nullptr : maker.Find(mesh.materials[number]);
    auto material = known ? maker.Make(*known) : LookWithoutMaterial(mesh, has_colors, file, maker, report);
    if (known && known->material.map_Kd) MapTexture(*known->material.map_Kd, part, report);
    if (material) {
      material->has_vertex_colors = has_colors;
      part.material = model.materials.size();
      model.materials.push_back(std::move(*material));
    }
    model.parts.push_back(std::move(part));
  }
  return model;
}

}  // namespace ray
