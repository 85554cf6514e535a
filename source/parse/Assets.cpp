#include "source/parse/Assets.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <vector>

#include "R2/ImageFile.h"
#include "source/parse/Text.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/text/NumberText.h"

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

/// Colors are light, or weights of light; heights and directions may be negative.
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

}  // namespace

std::string Assets::Read(const FoundFile& file) {
  files_read_.insert(file.shown);  // a mesh may be read twice, once for each way of shading it
  return files_.Read(file);
}

Assets::BoxedMesh Assets::Mesh(const std::string& name, const std::string& named_in, bool smooth) {
  return MeshOf(files_.Find(name, named_in), smooth ? Normals::wanted : Normals::unused);
}

Assets::BoxedMesh Assets::MeshOf(const FoundFile& file, Normals use) {
  const auto [place, is_new] = meshes_.try_emplace({file.canonical, use});
  if (is_new) place->second = ReadMesh(file, use);
  return place->second;
}

Assets::BoxedMesh Assets::ReadMesh(const FoundFile& file, Normals use) {
  const MeshFormat* format = MeshFormatForName(file.shown);
  if (!format)
    throw FileError{"cannot read " + QuotedPath(file.shown) + " as a mesh", "supported: " + MeshExtensions()};
  R3::MeshData data;
  {
    const Text text{file.shown, Read(file)};  // gone before the mesh is built from its data
    data = ReadMeshFile(*format, text, report_);
  }
  const bool has_triangles = !data.triangles.empty(), has_normals = !data.normals.empty();
  // A link may have an extension that tells more than that of the file it leads to.
  const std::string known_as = MeshFormatForName(file.canonical) == format ? file.canonical : std::string();
  BoxedMesh boxed{std::make_shared<const R3::Mesh>(std::move(data), use != Normals::unused, known_as), {}};
  boxed.bounds = Bounds(*boxed.mesh);

  const std::string place = Escaped(file.shown);
  if (!has_triangles) report_.Warn(place, "the mesh has no faces");
  if (const int dropped = boxed.mesh->DroppedTriangles(); dropped > 0)
    report_.Warn(place, dropped == 1 ? "1 degenerate triangle skipped"
                                     : std::to_string(dropped) + " degenerate triangles skipped");
  if (use == Normals::wanted && !has_normals)
    report_.Warn(place, "the mesh has no vertex normals: 'smooth' has no effect");
  return boxed;
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
    files_read_.insert(file.shown);  // it is the scene's all the same
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
    // Asked before decoding: a small file can hold a large picture, and a scene can name many.
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
