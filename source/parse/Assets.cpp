#include "source/parse/Assets.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>

#include "R2/ImageFile.h"
#include "source/parse/Model.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/parse/meshes/SmoothNormals.h"
#include "source/text/NumberText.h"
#include "source/text/Words.h"

namespace ray {
namespace {

std::span<const unsigned char> BytesOf(const std::string& text) {
  return {reinterpret_cast<const unsigned char*>(text.data()), text.size()};
}

R2::Image Linear(R2::Image image) {
  for (int y = 0; y < image.Height(); ++y)
    for (int x = 0; x < image.Width(); ++x) image.Set(x, y, R2::DecodeSrgb(image.At(x, y)));
  return image;
}

/// Checks the values of a texture. Colors are light, or weights of light; heights and directions may be negative.
void CheckTexels(const R2::Image& image, const FoundFile& file, Assets::Use use) {
  const bool is_color = use == Assets::Use::color;
  const auto is_fit = [&](float value) { return std::isfinite(value) && (value >= 0 || !is_color); };
  const R2::Image::Floats& values = image.Channels();
  const auto bad = std::ranges::find_if_not(values, is_fit);
  if (bad == values.end()) return;
  const auto pixel = (bad - values.begin()) / 3;
  throw FileError{"cannot use " + QuotedPath(file.shown) + " as a texture: values must be finite" +
                      (is_color ? " and not negative" : "") + ", but pixel " + std::to_string(pixel % image.Width()) +
                      " " + std::to_string(pixel / image.Width()) + " (from the left, from the bottom) has " +
                      ToText(double{*bad}),
                  {}};
}

/// Returns the name by which the same mesh can be read again, or an empty text. A link may have a more specific
/// extension than the file it leads to.
std::string KnownAs(const FoundFile& file, const Assets::Shading& shading) {
  const bool is_of_file = shading.normals != Assets::Shading::Normals::by_angle;
  const bool says_format = MeshFormatForName(file.canonical) == MeshFormatForName(file.shown);
  return is_of_file && says_format ? file.canonical : std::string();
}

Assets::BoxedMesh Boxed(R3::MeshData data, const Assets::Shading& shading, std::string known_as) {
  const bool is_smooth = shading.normals != Assets::Shading::Normals::of_triangles;
  Assets::BoxedMesh boxed{std::make_shared<const R3::Mesh>(std::move(data), is_smooth, std::move(known_as)), {}};
  boxed.bounds = Bounds(*boxed.mesh);
  return boxed;
}

}  // namespace

std::string Assets::Read(const FoundFile& file) {
  files_read_.insert(file.shown);  // a mesh may be read twice, once for each kind of shading
  return files_.Read(file);
}

Assets::BoxedMesh Assets::Mesh(const std::string& name, const std::string& named_in, const Shading& shading) {
  return MeshOf(files_.Find(name, named_in), shading);
}

Assets::BoxedMesh Assets::MeshOf(const FoundFile& file, const Shading& shading) {
  const auto [place, is_new] = meshes_.try_emplace({file.canonical, shading});
  if (!is_new) return place->second;
  MeshFile read = ReadMesh(file, shading);
  const std::size_t triangles = read.data.triangles.size();
  const bool has_look = read.HasLook();
  place->second = Boxed(std::move(read.data), shading, KnownAs(file, shading));
  place->second.has_look = has_look;
  WarnOfMesh(file, triangles, place->second.mesh->DroppedTriangles());
  return place->second;
}

std::shared_ptr<const Assets::Model> Assets::ModelNamed(const std::string& name, const std::string& named_in,
                                                        const Shading& shading) {
  return ModelOf(files_.Find(name, named_in), shading);
}

std::shared_ptr<const Assets::Model> Assets::ModelOf(const FoundFile& file, const Shading& shading) {
  const auto [place, is_new] = models_.try_emplace({file.canonical, shading});
  if (!is_new) return place->second;
  MeshFile read = ReadMesh(file, shading);
  const std::size_t triangles = read.data.triangles.size();
  ModelData cut = CutByMaterial(std::move(read), file, *this, report_);
  auto model = std::make_shared<Model>();
  model->materials = std::move(cut.materials);
  int dropped = 0;
  for (ModelData::Part& part : cut.parts) {
    const std::string known_as = part.is_whole ? KnownAs(file, shading) : std::string();
    model->parts.push_back({Boxed(std::move(part.data), shading, known_as), part.material});
    dropped += model->parts.back().mesh.mesh->DroppedTriangles();
  }
  WarnOfMesh(file, triangles, dropped);
  return place->second = std::move(model);
}

MeshFile Assets::ReadMesh(const FoundFile& file, const Shading& shading) {
  const MeshFormat* format = MeshFormatForName(file.shown);
  if (!format)
    throw FileError{"cannot read " + QuotedPath(file.shown) + " as a mesh", "supported: " + MeshExtensions()};
  MeshFile read = format->read({file.shown, Read(file)}, report_);
  using enum Shading::Normals;
  const bool takes_groups = shading.normals == wanted || shading.normals == of_file_or_groups;
  if (shading.normals == by_angle) SmoothByAngle(read.data, shading.degrees);
  if (takes_groups && !read.smoothing_runs.empty()) SmoothByGroups(read.data, read.smoothing_runs);
  if (shading.normals == wanted && read.data.normals.empty())
    report_.Warn(Escaped(file.shown), "the mesh has no vertex normals: 'smooth' has no effect");
  if (decode_srgb_ && read.has_8_bit_colors)
    for (auto& color : read.data.colors)
      for (float& channel : color) channel = static_cast<float>(R2::DecodeSrgb(double{channel}));
  return read;
}

void Assets::WarnOfMesh(const FoundFile& file, std::size_t triangles, int dropped) {
  const std::string place = Escaped(file.shown);
  if (triangles == 0) report_.Warn(place, "the mesh has no faces");
  if (dropped > 0)
    report_.Warn(place, Counted(static_cast<std::uint64_t>(dropped), "degenerate triangle") + " skipped");
}

bool Assets::DecodeSrgb() {
  const bool is_first = images_.empty() && environments_.empty() && meshes_.empty() && models_.empty();
  decode_srgb_ |= is_first;
  return decode_srgb_;
}

std::shared_ptr<const Texture> Assets::Image(const std::string& name, const std::string& named_in, Use use) {
  const FoundFile file = files_.Find(name, named_in);
  const auto [place, is_new] = images_.try_emplace({file.canonical, use});
  if (is_new) {
    R2::Image image = DecodeImage(file, Read(file), use);
    CheckTexels(image, file, use);
    place->second = std::make_shared<const Texture>(Texture{std::move(image), file.canonical});
  }
  return place->second;
}

std::shared_ptr<const Environment> Assets::EnvironmentNamed(const std::string& name, const std::string& named_in) {
  const FoundFile file = files_.Find(name, named_in);
  const auto [place, is_new] = environments_.try_emplace(file.canonical);
  if (!is_new) return place->second;
  if (environment_is_replaced_)
    files_read_.insert(file.shown);  // it belongs to the scene anyway
  else
    place->second = EnvironmentOf(file, Read(file));
  return place->second;
}

std::shared_ptr<const Environment> Assets::EnvironmentAtTop(const Files& files) {
  const FoundFile file = files.Top();
  return EnvironmentOf(file, files.Read(file));
}

std::shared_ptr<const Environment> Assets::EnvironmentOf(const FoundFile& file, const std::string& bytes) {
  try {
    return std::make_shared<const Environment>(DecodeImage(file, bytes, Use::color), file.canonical);
  } catch (const std::invalid_argument& error) {
    throw FileError{"cannot use " + QuotedPath(file.shown) + " as an environment: " + error.what(), {}};
  }
}

R2::Image Assets::DecodeImage(const FoundFile& file, const std::string& bytes, Use use) {
  try {
    const R2::ImageSize size = R2::ReadImageSize(BytesOf(bytes));
    texels_ += std::int64_t{size.width} * size.height;
    // Checked before decoding: a small file can contain a large image, and a scene can name many.
    if (texels_ > R2::max_pixels)
      throw FileError{"the scene's textures have more than " + std::to_string(R2::max_pixels) + " texels", {}};
    constexpr std::int64_t bytes_per_texel = 3 * sizeof(float);
    if (bytes_per_texel * texels_ > max_texture_bytes_)
      throw FileError{"the scene's textures take " + std::to_string(bytes_per_texel * texels_ >> 20) +
                          " MiB decoded, more than the limit of " + std::to_string(max_texture_bytes_ >> 20) + " MiB",
                      "-memory sets another limit"};
    R2::DecodedImage decoded = R2::DecodeImage(BytesOf(bytes));
    for (const std::string& warning : decoded.warnings) report_.Warn(Escaped(file.shown), warning);
    const bool is_encoded = decode_srgb_ && use == Use::color && !decoded.format->is_linear;
    return is_encoded ? Linear(std::move(decoded.image)) : std::move(decoded.image);
  } catch (const R2::ImageError& error) {
    throw FileError{"cannot read image " + QuotedPath(file.shown) + ": " + error.what(), {}};
  }
}

}  // namespace ray
