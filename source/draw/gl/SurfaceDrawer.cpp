#include "source/draw/gl/SurfaceDrawer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "source/draw/Drawing.h"
#include "source/draw/gl/Canvas.h"
#include "source/draw/gl/MirrorProbes.h"
#include "source/draw/gl/Objects.h"

namespace ray {

namespace {

constexpr const char* edge_vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 at;
uniform mat4 clip_from_drawing;
void main() { gl_Position = clip_from_drawing * vec4(at, 1); }
)";

// Edges of triangles that are small on the screen would leave nothing else to be seen: they are the fainter, the
// smaller. Those with a corner behind the eye are large.
constexpr const char* edge_geometry_shader = R"(#version 330 core
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
uniform vec2 half_size;  // of the viewport, in pixels
flat out float strength;
const float opaque_from = 12.0;  // pixels of the longest edge
const float faintest = 0.05;
void main() {
  vec2 at[3];
  bool is_in_front = true;
  for (int i = 0; i < 3; ++i) {
    is_in_front = is_in_front && gl_in[i].gl_Position.w > 0.0;
    at[i] = half_size * gl_in[i].gl_Position.xy / gl_in[i].gl_Position.w;
  }
  float longest = max(distance(at[0], at[1]), max(distance(at[1], at[2]), distance(at[2], at[0])));
  for (int i = 0; i < 3; ++i) {
    strength = is_in_front ? clamp(longest / opaque_from, faintest, 1.0) : 1.0;
    gl_Position = gl_in[i].gl_Position;
    EmitVertex();
  }
  EndPrimitive();
}
)";

constexpr const char* edge_fragment_shader = R"(#version 330 core
uniform vec3 ink;
flat in float strength;
out vec4 color;
void main() { color = vec4(ink, strength); }
)";

constexpr GLuint at_location = 0, normal_location = 1, uv_location = 2, color_location = 3, lights_binding = 0;
constexpr GLint paint_unit = 0, relief_unit = 1, environment_unit = 2, shadows_unit = 3, normal_map_unit = 4,
                specular_map_unit = 5, probe_unit = 6, probe_depths_unit = 7;
constexpr int most_texels = 2048;  // per side of a texture or environment: 24 MB in half precision
constexpr GLint few_lights = 8;    // that a renderer in software shades while the view moves
constexpr double rim = 0.25;       // brightness at the rim of a full mirror that shows nothing

constexpr float most_half = 65504;  // that a half-precision float can hold

void Set(const ShaderProgram& program, const char* name, const R2::Color& color) {
  glUniform3fv(program[name], 1, AsFloats(color).data());
}
void Set(const ShaderProgram& program, const char* name, double number) { glUniform1f(program[name], AsFloat(number)); }

/// A light in the layout of the shader's block.
struct GpuLight {
  std::array<float, 4> color, place, direction, falloff;
};
static_assert(sizeof(GpuLight) == 64);

GpuLight AsGpu(const PreviewLight& light, int first_shadow = 0) {
  const auto color = AsFloats(light.color);
  const auto &p = light.place, &d = light.direction;
  return {{color[0], color[1], color[2], AsFloat(light.exponent)},
          {p[0], p[1], p[2],
           light.is_infinite ? 1.F
           : light.is_disc   ? -AsFloat(light.radius)
                             : 0.F},
          {d[0], d[1], d[2], AsFloat(light.least_cosine)},
          {AsFloat(light.constant), AsFloat(light.linear), AsFloat(light.quadratic), static_cast<float>(first_shadow)}};
}

bool IsOfBytes(const R2::Image& image) {
  return std::ranges::all_of(image.Channels(), [](float c) {
    const float byte = 255 * c;
    return byte >= 0 && byte <= 255 && std::abs(byte - std::round(byte)) < 1e-4F;
  });
}

/// Fills the texture bound, and its smaller levels, for which llvmpipe would first compile a shader. In bytes where
/// nothing is lost by it, unless slopes are asked for, which bytes would round between texels.
void FillTexture(const R2::Image& original, bool has_slopes) {
  R2::Image image = Shrunk(original, most_texels, most_texels);
  const GLint format = !has_slopes && IsOfBytes(image) ? GL_RGB8 : GL_RGB16F;
  for (GLint level = 0;; ++level) {
    R2::Image::Floats channels = image.Channels();
    for (float& c : channels) c = std::clamp(c, -most_half, most_half);
    glTexImage2D(GL_TEXTURE_2D, level, format, image.Width(), image.Height(), 0, GL_RGB, GL_FLOAT, channels.data());
    if (image.Width() == 1 && image.Height() == 1) break;
    image = Shrunk(image, std::max(1, image.Width() / 2), std::max(1, image.Height() / 2));
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  CheckMemory();
}

void AddTexture(std::unordered_map<const Texture*, Texture2D>& textures, const Texture* texture, bool has_slopes) {
  if (!texture || textures.count(texture)) return;
  const Texture2D& made = textures.try_emplace(texture).first->second;
  glBindTexture(GL_TEXTURE_2D, made.Name());
  FillTexture(texture->image, has_slopes);
}

SurfaceFeatures FeaturesOf(const ScenePicture& picture) {
  SurfaceFeatures features;
  features.environment = picture.environment != nullptr;
  features.diffuse_light =
      std::ranges::any_of(picture.diffuse_light.factors, [](const R2::Color& c) { return !IsBlack(c); });
  features.discs = std::ranges::any_of(picture.lights.lights, &PreviewLight::is_disc);
  for (const SurfaceBatch& batch : picture.surfaces.batches) {
    features.vertex_colors |= batch.material.has_vertex_colors;
    features.textures |= batch.material.texture || batch.material.has_vertex_colors;
    features.bumps |= batch.material.bump != nullptr;
    features.normal_maps |= batch.material.normal_map != nullptr;
    features.specular_maps |= batch.material.specular_map != nullptr;
    features.clear |= !IsBlack(batch.material.kt);
    features.coats |= batch.material.coat > 0;
  }
  features.fresnel = picture.fresnel && features.clear;
  if (IsPreviewed(picture.look.mode) && picture.look.mode != RenderMode::path) features.mode = picture.look.mode;
  return features;
}

/// Whether a surface shows what is in another direction than straight behind it.
bool Mirrors(const SurfaceMaterial& m, const SurfaceFeatures& features) {
  const bool is_clear = !IsBlack(m.kt);
  return features.mode == RenderMode::whitted && (!IsBlack(m.kr) || m.coat > 0 || (is_clear && m.ir != 1));
}

/// Whether what a surface mirrors changes few levels of what is seen.
bool IsFaint(const SurfaceMaterial& m) {
  constexpr double faint = 0.1;
  return IsBlack(m.kt) && m.coat == 0 && std::max({m.kr.r, m.kr.g, m.kr.b}) <= faint;
}

/// Whether to find first what is seen at each pixel saves more than it costs: it is then shaded once, not once for each
/// surface that is drawn before something nearer.
bool IsShadingDear(const SurfacePass& pass) {
  constexpr std::size_t many_lights = 4;
  const std::size_t lights = std::min(pass.surfaces.preview_lights.size(), static_cast<std::size_t>(pass.most_lights));
  return pass.features.mode == RenderMode::whitted && lights >= many_lights;
}

void DrawTriangles(const SurfaceBatch& batch) {
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(batch.count), GL_UNSIGNED_INT,
                 Offset(batch.first * sizeof(std::uint32_t)));
}

/// Batches that one program shades follow each other, so that programs are changed rarely.
std::vector<SurfaceBatch> InDrawingOrder(std::vector<SurfaceBatch> batches, const SurfaceFeatures& features) {
  std::ranges::stable_sort(batches, {}, [&](const SurfaceBatch& batch) {
    return std::pair(batch.is_clear, Mirrors(batch.material, features));
  });
  return batches;
}

void UploadTriangles(GpuTriangles& uploaded, const Surfaces& surfaces, const SurfaceFeatures& features) {
  uploaded.batches = InDrawingOrder(surfaces.batches, features);
  assert(std::ranges::all_of(surfaces.indices, [&](auto i) { return i < surfaces.vertices.size(); }));
  glBindVertexArray(uploaded.shaded.Name());  // indices belong to the array bound when they come
  glBindBuffer(GL_ARRAY_BUFFER, uploaded.vertices.Name());
  glBufferData(GL_ARRAY_BUFFER, Bytes(surfaces.vertices), surfaces.vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, uploaded.indices.Name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, Bytes(surfaces.indices), surfaces.indices.data(), GL_STATIC_DRAW);
  Describe(at_location, 3, GL_FLOAT, sizeof(SurfaceVertex), offsetof(SurfaceVertex, at));
  Describe(normal_location, 4, GL_SHORT, sizeof(SurfaceVertex), offsetof(SurfaceVertex, normal));
  if (!surfaces.uvs.empty()) {
    assert(surfaces.uvs.size() == surfaces.vertices.size());
    glBindBuffer(GL_ARRAY_BUFFER, uploaded.uvs.Name());
    glBufferData(GL_ARRAY_BUFFER, Bytes(surfaces.uvs), surfaces.uvs.data(), GL_STATIC_DRAW);
    Describe(uv_location, 2, GL_FLOAT, sizeof(surfaces.uvs[0]), 0);
    glBindBuffer(GL_ARRAY_BUFFER, uploaded.vertices.Name());
  }
  if (!surfaces.colors.empty()) {
    glBindBuffer(GL_ARRAY_BUFFER, uploaded.colors.Name());
    glBufferData(GL_ARRAY_BUFFER, Bytes(surfaces.colors), surfaces.colors.data(), GL_STATIC_DRAW);
    Describe(color_location, 3, GL_FLOAT, sizeof(surfaces.colors[0]), 0);
    glBindBuffer(GL_ARRAY_BUFFER, uploaded.vertices.Name());
  }
  glBindVertexArray(uploaded.plain.Name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, uploaded.indices.Name());
  Describe(at_location, 3, GL_FLOAT, sizeof(SurfaceVertex), offsetof(SurfaceVertex, at));
  CheckMemory();
}

/// Where the shadows of a light are, as the shader decodes it: the first view, and 64 for each place but the first.
int ShadowCode(const ShadowViews& views, std::size_t light) {
  static_assert(most_shadow_views < 64);
  const int first = views.first[light], more = 64 * (views.places[light] - 1);
  return first < 0 ? first - more : first + more;
}

void UploadLights(const GpuSurfaces& surfaces) {
  std::vector<GpuLight> lights;
  for (const bool are_discs : {true, false})
    for (std::size_t i = 0; i < surfaces.preview_lights.size(); ++i)
      if (surfaces.preview_lights[i].is_disc == are_discs)
        lights.push_back(
            AsGpu(surfaces.preview_lights[i], surfaces.shadows ? ShadowCode(surfaces.shadow_views, i) : 0));
  lights.resize(most_preview_lights);
  glBindBuffer(GL_UNIFORM_BUFFER, surfaces.lights.Name());
  glBufferData(GL_UNIFORM_BUFFER, Bytes(lights), lights.data(), GL_STATIC_DRAW);
}

/// So many that they are drawn within a second or two by a renderer in software, at least one.
std::size_t MostShadowViews(const std::vector<SurfaceBatch>& batches) {
  constexpr std::size_t most_triangles = 8'000'000;
  std::size_t triangles = 1;
  for (const SurfaceBatch& batch : batches) triangles += batch.count / 3;
  return std::clamp<std::size_t>(most_triangles / triangles, 1, most_shadow_views);
}

void DrawOpaque(const SurfaceBatch& batch) {
  if (batch.material.one_sided) {
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
  }
  DrawTriangles(batch);
  glDisable(GL_CULL_FACE);
}

/// The far side of a solid first; without writing depth, so that what comes later is seen behind.
void DrawClear(const SurfaceBatch& batch) {
  glEnable(GL_BLEND);
  // Light that comes through is multiplied color by color.
  glBlendFuncSeparate(GL_ONE, GL_SRC1_COLOR, GL_ONE, GL_ZERO);
  glDepthMask(GL_FALSE);
  glEnable(GL_CULL_FACE);
  for (const GLenum hidden : std::array<GLenum, 2>{GL_FRONT, GL_BACK}) {
    glCullFace(hidden);
    DrawTriangles(batch);
  }
  glDisable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
}

}  // namespace

SurfaceDrawer::SurfaceDrawer() {
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glSamplerParameteri(largest_level_.Name(), name, GL_LINEAR);
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glSamplerParameteri(largest_level_.Name(), name, GL_CLAMP_TO_EDGE);
}

std::shared_ptr<GpuSurfaces> SurfaceDrawer::Upload(const ScenePicture& picture) const {
  auto uploaded = std::make_shared<GpuSurfaces>();
  uploaded->diffuse_light = picture.diffuse_light;
  uploaded->background = picture.background;
  uploaded->features = FeaturesOf(picture);
  uploaded->head_light = picture.lights.head_light;
  uploaded->preview_lights = picture.lights.lights;
  uploaded->probes = picture.surfaces.probes;
  uploaded->mirror_bounces = picture.mirror_bounces;
  uploaded->look = picture.look;
  UploadTriangles(uploaded->all, picture.surfaces, uploaded->features);

  UploadLights(*uploaded);
  glActiveTexture(GL_TEXTURE0);
  for (const SurfaceBatch& batch : picture.surfaces.batches) {
    AddTexture(uploaded->textures, batch.material.texture.get(), false);
    AddTexture(uploaded->textures, batch.material.specular_map.get(), false);
    AddTexture(uploaded->reliefs, batch.material.bump.get(), true);
    AddTexture(uploaded->reliefs, batch.material.normal_map.get(), true);
  }
  if (picture.environment) {
    glBindTexture(GL_TEXTURE_2D, uploaded->environment.emplace().Name());
    FillTexture(picture.environment->Map(), true);
    // A texel has one color, as the tracer sees it.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  return uploaded;
}

void SurfaceDrawer::SetFewer(GpuSurfaces& surfaces, const std::shared_ptr<const Surfaces>& fewer) const {
  if (surfaces.fewer_of == fewer) return;
  surfaces.fewer.reset();  // first, so that both are never there at once
  surfaces.fewer_of = fewer;
  if (fewer) UploadTriangles(surfaces.fewer.emplace(), *fewer, surfaces.features);
}

void SurfaceDrawer::SetShadows(GpuSurfaces& surfaces, bool is_on) const {
  if (is_on && !surfaces.shadows) {
    surfaces.shadow_views = ShadowViewsOf(surfaces.preview_lights, MostShadowViews(surfaces.all.batches));
    const auto& views = surfaces.shadow_views.clip_from_drawing;
    if (views.empty()) return;
    const ShaderProgram& depth = UseDepth();
    glBindVertexArray(surfaces.all.plain.Name());
    surfaces.shadows.emplace(FilledShadows(static_cast<int>(views.size()), [&](int map) {
      SetMatrix(depth["clip_from_drawing"], views[static_cast<std::size_t>(map)]);
      for (const SurfaceBatch& batch : surfaces.all.batches) DrawTriangles(batch);
    }));
    UploadLights(surfaces);
  }
  surfaces.features.shadows = is_on && surfaces.shadows;
}

const ShaderProgram& SurfaceDrawer::UseDepth() const {
  if (!depth_)
    depth_ = std::make_unique<ShaderProgram>("depths", DepthVertexShader().c_str(), DepthFragmentShader().c_str());
  depth_->Use();
  return *depth_;
}

const ShaderProgram& SurfaceDrawer::ProgramFor(const SurfaceFeatures& features) const {
  for (const Made& made : programs_)
    if (made.features == features) return *made.program;
  programs_.push_back({features, std::make_unique<ShaderProgram>("surfaces", SurfaceVertexShader().c_str(),
                                                                 SurfaceFragmentShader(features).c_str())});
  const ShaderProgram& program = *programs_.back().program;
  program.Use();
  glUniform1i(program["paint"], paint_unit);
  glUniform1i(program["relief"], relief_unit);
  glUniform1i(program["normal_map"], normal_map_unit);
  glUniform1i(program["specular_map"], specular_map_unit);
  glUniform1i(program["environment"], environment_unit);
  glUniform1i(program["shadow_maps"], shadows_unit);
  glUniform1i(program["probe"], probe_unit);
  glUniform1i(program["probe_depths"], probe_depths_unit);
  glUniformBlockBinding(program.Name(), glGetUniformBlockIndex(program.Name(), "Lights"), lights_binding);
  return program;
}

/// What does not differ from material to material.
void SurfaceDrawer::Use(const ShaderProgram& program, const GpuSurfaces& surfaces, const PreviewView& view,
                        bool for_probe) const {
  program.Use();
  glUniform1i(program["for_probe"], for_probe ? 1 : 0);
  Set(program, "exposure", view.exposure.factor);
  glUniform1i(program["srgb"], view.exposure.srgb ? 1 : 0);
  if (!surfaces.environment) return Set(program, "background", surfaces.background);
  glActiveTexture(GL_TEXTURE0 + environment_unit);
  glBindTexture(GL_TEXTURE_2D, surfaces.environment->Name());
  glActiveTexture(GL_TEXTURE0);
}

void SurfaceDrawer::DrawSky(const GpuSurfaces& surfaces, const PreviewView& view, bool for_probe) const {
  if (!surfaces.environment || !ShowsBackground(surfaces.look.mode)) return;
  if (!sky_) {
    sky_ = std::make_unique<ShaderProgram>("the environment", SkyVertexShader().c_str(), SkyFragmentShader().c_str());
    sky_->Use();
    glUniform1i((*sky_)["environment"], environment_unit);
  }
  Use(*sky_, surfaces, view, for_probe);
  glUniform3fv((*sky_)["directions"], 3, view.directions[0].data());
  glBindVertexArray(nothing_.Name());
  glDisable(GL_DEPTH_TEST);  // which leaves depth unwritten as well
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
}

void SurfaceDrawer::UseMaterial(const ShaderProgram& program, const GpuSurfaces& surfaces,
                                const SurfaceMaterial& m) const {
  Set(program, "emission", m.emission);
  Set(program, "ambient", m.ambient);
  Set(program, "kd", m.kd);
  Set(program, "ks", m.ks);
  Set(program, "kr", m.kr);
  Set(program, "through", m.kt);
  Set(program, "exponent", m.n);
  Set(program, "lobe", m.lobe);
  Set(program, "ir", m.ir);
  Set(program, "coat", m.coat);
  Set(program, "least_rim", rim * std::max(Luminance(m.kr), Luminance(m.kt)));
  Set(program, "flat_painted", m.flat_painted);
  Set(program, "flat_plain", m.flat_plain);
  glUniform2f(program["texture_scale"], static_cast<float>(m.texture_scale.x), static_cast<float>(m.texture_scale.y));
  if (surfaces.features.textures) {
    glUniform1i(program["is_painted"], m.texture ? 1 : 0);
    glUniform1i(program["is_ambient_painted"], m.texture_multiplies_ambient ? 1 : 0);
    if (m.texture) glBindTexture(GL_TEXTURE_2D, surfaces.textures.at(m.texture.get()).Name());
  }
  const auto bind = [](GLint unit, const auto& images, const std::shared_ptr<const Texture>& image) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, images.at(image.get()).Name());
    glActiveTexture(GL_TEXTURE0);
  };
  if (surfaces.features.specular_maps) {
    glUniform1i(program["is_specular_mapped"], m.specular_map ? 1 : 0);
    if (m.specular_map) bind(specular_map_unit, surfaces.textures, m.specular_map);
  }
  if (surfaces.features.bumps) {
    Set(program, "height", m.bump ? m.bump_height : 0);
    if (m.bump) bind(relief_unit, surfaces.reliefs, m.bump);
  }
  if (surfaces.features.normal_maps) {
    glUniform1i(program["is_mapped"], m.normal_map ? 1 : 0);
    if (m.normal_map) bind(normal_map_unit, surfaces.reliefs, m.normal_map);
  }
}

/// What shines on the surfaces.
void SurfaceDrawer::UseLights(const ShaderProgram& program, const GpuSurfaces& surfaces,
                              const SurfaceFeatures& features, const PreviewView& view, GLint most_lights) const {
  std::array<float, 27> diffuse_light{};
  for (std::size_t i = 0; i < 9; ++i)
    std::ranges::copy(AsFloats(surfaces.diffuse_light.factors[i]), diffuse_light.begin() + 3 * i);
  glUniform3fv(program["diffuse_light"], 9, diffuse_light.data());
  if (features.shadows) {
    glActiveTexture(GL_TEXTURE0 + shadows_unit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, surfaces.shadows->maps.Name());
    glActiveTexture(GL_TEXTURE0);
    SetMatrices(program["shadow_views"], surfaces.shadow_views.clip_from_drawing);
  }
  glBindBufferBase(GL_UNIFORM_BUFFER, lights_binding, surfaces.lights.Name());
  if (surfaces.head_light) {
    const GpuLight at_eye = AsGpu({.color = {1, 1, 1}, .place = view.eye});
    glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(at_eye), &at_eye);
  }
  const auto discs = static_cast<GLint>(std::ranges::count(surfaces.preview_lights, true, &PreviewLight::is_disc));
  if (surfaces.features.discs) glUniform1i(program["disc_count"], std::min(discs, most_lights));
  const auto lights = static_cast<GLint>(surfaces.preview_lights.size());
  glUniform1i(program["light_count"], surfaces.head_light ? 1 : std::min(lights, most_lights));
}

void SurfaceDrawer::Draw(const GpuSurfaces& surfaces, const ClipMatrix& clip_from_drawing, const PreviewView& view,
                         const DrawingDetail& detail) const {
  const GpuTriangles& triangles = detail.is_sparse && surfaces.fewer ? *surfaces.fewer : surfaces.all;
  if (triangles.batches.empty()) return;
  SurfaceFeatures features = surfaces.features;
  features.probes = detail.has_mirrors && !surfaces.probe_maps.empty();
  const bool encodes = view.exposure.srgb && CanEncodeSrgb();
  if (encodes) glEnable(GL_FRAMEBUFFER_SRGB);

  // Moved back a little, by their slope and the smallest step of depth, so that lines on them are seen.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 1);
  const GLint most_lights = detail.is_sparse ? few_lights : static_cast<GLint>(most_preview_lights);
  const SurfacePass pass{surfaces, triangles, features, clip_from_drawing, view, most_lights, encodes};
  if (IsShadingDear(pass)) DrawDepths(pass);
  DrawBatches(pass);
  if (encodes) glDisable(GL_FRAMEBUFFER_SRGB);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glEnable(GL_BLEND);
  UseAlpha();
}

const ShaderProgram& SurfaceDrawer::UseFor(const SurfacePass& pass, bool mirrors) const {
  SurfaceFeatures features = pass.features;
  features.mirrors = mirrors;
  features.probes = mirrors && features.probes;
  const ShaderProgram& program = ProgramFor(features);
  Use(program, pass.surfaces, pass.view, pass.probe != no_probe);
  if (pass.is_encoded) glUniform1i(program["srgb"], 0);
  SetMatrix(program["clip_from_drawing"], pass.clip_from_drawing);
  glUniform3fv(program["eye"], 1, pass.view.eye.data());
  UseLights(program, pass.surfaces, features, pass.view, pass.most_lights);
  UseMode(program, pass.surfaces, pass.view);
  return program;
}

void SurfaceDrawer::DrawDepths(const SurfacePass& pass) const {
  SetMatrix(UseDepth()["clip_from_drawing"], pass.clip_from_drawing);
  glBindVertexArray(pass.triangles.plain.Name());
  glEnable(GL_DEPTH_CLAMP);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  for (const SurfaceBatch& batch : pass.triangles.batches)
    if (!batch.is_clear) DrawOpaque(batch);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_DEPTH_CLAMP);
}

void SurfaceDrawer::DrawBatches(const SurfacePass& pass) const {
  glBindVertexArray(pass.triangles.shaded.Name());
  glEnable(GL_DEPTH_CLAMP);  // what has no end goes on behind the farthest depth
  glDisable(GL_BLEND);
  const ShaderProgram* program = nullptr;
  bool program_mirrors = false;
  for (const SurfaceBatch& batch : pass.triangles.batches) {
    if (pass.probe != no_probe && batch.probe == pass.probe && batch.owns_probe) continue;
    const bool mirrors = Mirrors(batch.material, pass.features);
    if (!program || mirrors != program_mirrors) program = &UseFor(pass, mirrors);
    program_mirrors = mirrors;
    UseMaterial(*program, pass.surfaces, batch.material);
    glUniform1i((*program)["bends"], batch.material.ir != 1 && !batch.is_clear ? 1 : 0);
    if (mirrors && pass.features.probes) UseProbe(*program, pass.surfaces, batch);
    if (batch.is_clear && pass.features.mode == RenderMode::whitted)
      DrawClear(batch);
    else
      DrawOpaque(batch);
  }
  glDisable(GL_DEPTH_CLAMP);
}

void SurfaceDrawer::UseProbe(const ShaderProgram& program, const GpuSurfaces& surfaces,
                             const SurfaceBatch& batch) const {
  glUniform1i(program["has_probe"], batch.probe == no_probe ? 0 : 1);
  glUniform1i(program["is_faint"], IsFaint(batch.material) ? 1 : 0);
  if (batch.probe == no_probe) return;
  const auto i = static_cast<std::size_t>(batch.probe);
  glUniform3fv(program["probe_at"], 1, surfaces.probes[i].at.data());
  for (const GLint unit : {probe_unit, probe_depths_unit}) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_CUBE_MAP, surfaces.probe_maps[i].Name());
  }
  glBindSampler(probe_depths_unit, largest_level_.Name());
  glActiveTexture(GL_TEXTURE0);
}

void SurfaceDrawer::UseMode(const ShaderProgram& program, const GpuSurfaces& surfaces, const PreviewView& view) const {
  constexpr double dimmest_of_layer = 0.1;  // see LayerAsShown
  const ModeLook& look = surfaces.look;
  if (ShowsDepth(look.mode)) {
    glUniform2fv(program["depths"], 1, view.depths.data());
    Set(program, "dimmest", look.mode == RenderMode::depth ? dimmest_of_layer : 0);
  } else if (look.mode == RenderMode::gooch) {
    glUniform4f(program["tones"], AsFloat(look.gooch.blue), AsFloat(look.gooch.yellow), AsFloat(look.gooch.alpha),
                AsFloat(look.gooch.beta));
  } else if (look.mode == RenderMode::toon) {
    Set(program, "bands", look.toon_bands);
  }
}

void SurfaceDrawer::DrawProbes(GpuSurfaces& surfaces) const {
  const bool has_light = surfaces.features.mode == RenderMode::whitted;
  const bool are_due = surfaces.probe_maps.empty() || surfaces.probes_have_shadows != surfaces.features.shadows;
  if (!has_light || surfaces.probes.empty() || !are_due) return;
  surfaces.probes_have_shadows = surfaces.features.shadows;
  surfaces.probe_maps.clear();
  SurfaceFeatures features = surfaces.features;
  // All probes together have some 400,000 texels: a software renderer shades them in about half a second.
  const std::size_t count = surfaces.probes.size();
  const GLsizei texels = count <= 1 ? 256 : count <= 4 ? 128 : 64;
  // Mirrors of a later round show those of the one before, in which half of the texels a side will do.
  for (int bounce = 0; bounce < surfaces.mirror_bounces; ++bounce) {
    features.probes = bounce > 0;
    const bool is_last = bounce + 1 == surfaces.mirror_bounces;
    std::vector<Texture2D> maps;
    for (std::size_t i = 0; i < count; ++i)
      maps.push_back(FilledProbe(is_last ? texels : texels / 2, surfaces.background,
                                 [&](int side) { DrawSide(surfaces, features, i, side); }));
    surfaces.probe_maps = std::move(maps);
  }
}

void SurfaceDrawer::DrawSide(const GpuSurfaces& surfaces, const SurfaceFeatures& features, std::size_t probe,
                             int side) const {
  const ProbeSide seen = SideOf(surfaces.probes[probe], side);
  DrawSky(surfaces, seen.view, true);
  DrawBatches({surfaces, surfaces.all, features, seen.clip_from_drawing, seen.view,
               static_cast<GLint>(most_preview_lights), false, static_cast<int>(probe)});
}

void SurfaceDrawer::DrawEdges(const GpuSurfaces& surfaces, const ClipMatrix& clip_from_drawing,
                              const Rgba& color) const {
  if (!edges_)
    edges_ = std::make_unique<ShaderProgram>("edges", edge_vertex_shader, edge_fragment_shader, edge_geometry_shader);
  edges_->Use();
  SetMatrix((*edges_)["clip_from_drawing"], clip_from_drawing);
  Set(*edges_, "ink", R2::Color{color[0] / 255.0, color[1] / 255.0, color[2] / 255.0});
  std::array<GLint, 4> viewport{};
  glGetIntegerv(GL_VIEWPORT, viewport.data());
  glUniform2f((*edges_)["half_size"], static_cast<float>(viewport[2]) / 2, static_cast<float>(viewport[3]) / 2);
  glBindVertexArray(surfaces.all.plain.Name());
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  for (const SurfaceBatch& batch : surfaces.all.batches) DrawTriangles(batch);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

}  // namespace ray
