#include "source/draw/gl/SurfaceDrawer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "source/draw/Drawing.h"
#include "source/draw/gl/Canvas.h"
#include "source/draw/gl/Objects.h"

namespace ray {
namespace {

constexpr const char* edge_vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 at;
uniform mat4 clip_from_drawing;
void main() { gl_Position = clip_from_drawing * vec4(at, 1); }
)";

// The edges of triangles that are small on the screen would cover everything else, so they are fainter. Triangles with
// a corner behind the eye count as large.
constexpr const char* edge_geometry_shader = R"(#version 330 core
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
uniform vec2 half_size;  // of the viewport, in pixels
flat out float strength;
const float opaque_from = 12.0;  // in pixels of the longest edge
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
constexpr GLint paint_unit = 0, environment_unit = 1, shadows_unit = 2;
constexpr int most_texels = 2048;   // on a side of a texture or environment: 24 MB in half precision
constexpr GLsizei map_side = 1024;  // texels; resolves a scene seen from outside to 1/500 of its radius

constexpr float most_half = 65504;  // maximum of a half-precision float

void Set(const ShaderProgram& program, const char* name, const R2::Color& color) {
  glUniform3fv(program[name], 1, AsFloats(color).data());
}
void Set(const ShaderProgram& program, const char* name, double number) { glUniform1f(program[name], AsFloat(number)); }

/// A light in the layout of the shader's block.
struct GpuLight {
  std::array<float, 4> color, place, direction, falloff;
};
static_assert(sizeof(GpuLight) == 64);

GpuLight AsGpu(const PreviewLight& light) {
  const auto color = AsFloats(light.color);
  const auto &p = light.place, &d = light.direction;
  return {{color[0], color[1], color[2], AsFloat(light.exponent)},
          {p[0], p[1], p[2], light.is_infinite ? 1.F : 0.F},
          {d[0], d[1], d[2], AsFloat(light.least_cosine)},
          {AsFloat(light.constant), AsFloat(light.linear), AsFloat(light.quadratic), 0}};
}

bool IsOfBytes(const R2::Image& image) {
  return std::ranges::all_of(image.Channels(), [](float c) {
    const float byte = 255 * c;
    return byte >= 0 && byte <= 255 && std::abs(byte - std::round(byte)) < 1e-4F;
  });
}

/// Fills the bound texture, and its smaller levels, for which llvmpipe would otherwise compile a shader. Uses bytes if
/// they lose nothing.
void FillTexture(const R2::Image& original) {
  R2::Image image = Shrunk(original, most_texels, most_texels);
  const GLint format = IsOfBytes(image) ? GL_RGB8 : GL_RGB16F;
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

bool Mirrors(const SurfaceBatch& batch) { return !IsBlack(batch.material.kr) || batch.is_clear; }

void DrawTriangles(const SurfaceBatch& batch) {
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(batch.count), GL_UNSIGNED_INT,
                 Offset(batch.first * sizeof(std::uint32_t)));
}

void UploadTriangles(GpuSurfaces& uploaded, const Surfaces& surfaces) {
  uploaded.batches = surfaces.batches;
  // Batches of the same program are adjacent, so that programs are changed rarely.
  std::ranges::stable_sort(uploaded.batches, {},
                           [](const SurfaceBatch& batch) { return std::pair(batch.is_clear, Mirrors(batch)); });
  assert(std::ranges::all_of(surfaces.indices, [&](auto i) { return i < surfaces.vertices.size(); }));
  glBindVertexArray(uploaded.shaded.Name());  // indices belong to the array bound when they are set
  const auto describe = [](const Buffer& buffer, const auto& list, GLuint location, GLint count, GLenum type,
                           std::size_t offset = 0) {
    if (list.empty()) return;
    glBindBuffer(GL_ARRAY_BUFFER, buffer.Name());
    Describe(location, count, type, sizeof(list[0]), offset);
  };
  const auto fill = [](GLenum target, const Buffer& buffer, const auto& list) {
    glBindBuffer(target, buffer.Name());
    glBufferData(target, Bytes(list), list.data(), GL_STATIC_DRAW);
  };
  fill(GL_ARRAY_BUFFER, uploaded.vertices, surfaces.vertices);
  fill(GL_ARRAY_BUFFER, uploaded.uvs, surfaces.uvs);
  fill(GL_ARRAY_BUFFER, uploaded.colors, surfaces.colors);
  fill(GL_ELEMENT_ARRAY_BUFFER, uploaded.indices, surfaces.indices);
  describe(uploaded.vertices, surfaces.vertices, at_location, 3, GL_FLOAT, offsetof(SurfaceVertex, at));
  describe(uploaded.vertices, surfaces.vertices, normal_location, 4, GL_SHORT, offsetof(SurfaceVertex, normal));
  describe(uploaded.uvs, surfaces.uvs, uv_location, 2, GL_FLOAT);
  describe(uploaded.colors, surfaces.colors, color_location, 3, GL_FLOAT);
  glBindVertexArray(uploaded.plain.Name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, uploaded.indices.Name());
  describe(uploaded.vertices, surfaces.vertices, at_location, 3, GL_FLOAT, offsetof(SurfaceVertex, at));
  CheckMemory();
}

void UploadLights(const GpuSurfaces& surfaces) {
  std::vector<GpuLight> lights;
  for (const PreviewLight& light : surfaces.preview_lights.lights) lights.push_back(AsGpu(light));
  lights.resize(most_preview_lights);
  glBindBuffer(GL_UNIFORM_BUFFER, surfaces.lights.Name());
  glBufferData(GL_UNIFORM_BUFFER, Bytes(lights), lights.data(), GL_STATIC_DRAW);
}

void DrawOpaque(const SurfaceBatch& batch) {
  if (batch.material.one_sided) {
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
  }
  DrawTriangles(batch);
  glDisable(GL_CULL_FACE);
}

/// Draws the far side of a solid first, without writing depth, so that later drawing is visible behind.
void DrawClear(const SurfaceBatch& batch) {
  glEnable(GL_BLEND);
  // Transmitted light is multiplied per channel.
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

std::shared_ptr<GpuSurfaces> SurfaceDrawer::Upload(const PreviewScene& preview) const {
  auto uploaded = std::make_shared<GpuSurfaces>();
  uploaded->around = preview.around;
  uploaded->background = preview.background;
  uploaded->preview_lights = preview.lights;
  uploaded->has_colors = !preview.surfaces.colors.empty();
  UploadTriangles(*uploaded, preview.surfaces);
  UploadLights(*uploaded);
  glActiveTexture(GL_TEXTURE0);
  for (const SurfaceBatch& batch : preview.surfaces.batches) {
    const Texture* texture = batch.material.texture.get();
    if (!texture || uploaded->textures.contains(texture)) continue;
    glBindTexture(GL_TEXTURE_2D, uploaded->textures[texture].Name());
    FillTexture(texture->image);
  }
  if (preview.environment) {
    glBindTexture(GL_TEXTURE_2D, uploaded->environment.emplace().Name());
    FillTexture(preview.environment->Map());
    // A texel has one color, as in the tracer.
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  return uploaded;
}

void SurfaceDrawer::DrawShadows(GpuSurfaces& surfaces) const {
  const auto& lights = surfaces.preview_lights.lights;
  if (surfaces.shadow_maps || lights.empty()) return;
  for (std::size_t i = 0; i < std::min(lights.size(), most_preview_shadows); ++i)
    surfaces.shadow_views.push_back(ShadowViewOf(lights[i]));
  glActiveTexture(GL_TEXTURE0 + shadows_unit);
  glBindTexture(GL_TEXTURE_2D_ARRAY, surfaces.shadow_maps.emplace().Name());
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT24, map_side, map_side,
               static_cast<GLsizei>(surfaces.shadow_views.size()), 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  ReadFirstLevel(GL_TEXTURE_2D_ARRAY, GL_LINEAR);  // interpolates the results of four texels
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glActiveTexture(GL_TEXTURE0);
  CheckMemory();

  if (!depth_)
    depth_ = std::make_unique<ShaderProgram>("depths", DepthVertexShader().c_str(), DepthFragmentShader().c_str());
  depth_->Use();
  const KeptTarget kept;
  const Framebuffer framebuffer;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.Name());
  glDrawBuffer(GL_NONE);
  glViewport(0, 0, map_side, map_side);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(2, 2);  // so that a surface does not shadow itself where a texel is seen at an angle
  glBindVertexArray(surfaces.plain.Name());
  for (std::size_t i = 0; i < surfaces.shadow_views.size(); ++i) {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, surfaces.shadow_maps->Name(), 0,
                              static_cast<GLint>(i));
    glClear(GL_DEPTH_BUFFER_BIT);
    SetMatrix((*depth_)["clip_from_drawing"], surfaces.shadow_views[i]);
    for (const SurfaceBatch& batch : surfaces.batches) DrawTriangles(batch);
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
}

const ShaderProgram& SurfaceDrawer::ProgramFor(const SurfaceFeatures& features) const {
  for (const Made& made : programs_)
    if (made.features == features) return *made.program;
  programs_.push_back({features, std::make_unique<ShaderProgram>("surfaces", SurfaceVertexShader().c_str(),
                                                                 SurfaceFragmentShader(features).c_str())});
  const ShaderProgram& program = *programs_.back().program;
  program.Use();
  glUniform1i(program["paint"], paint_unit);
  glUniform1i(program["environment"], environment_unit);
  glUniform1i(program["shadow_maps"], shadows_unit);
  glUniformBlockBinding(program.Name(), glGetUniformBlockIndex(program.Name(), "Lights"), lights_binding);
  return program;
}

/// Sets the uniforms that are independent of materials.
void SurfaceDrawer::UseView(const ShaderProgram& program, const GpuSurfaces& surfaces, const PreviewView& view) const {
  program.Use();
  Set(program, "exposure", view.exposure.factor);
  glUniform1i(program["srgb"], view.exposure.srgb ? 1 : 0);
  if (!surfaces.environment) return Set(program, "background", surfaces.background);
  glActiveTexture(GL_TEXTURE0 + environment_unit);
  glBindTexture(GL_TEXTURE_2D, surfaces.environment->Name());
  glActiveTexture(GL_TEXTURE0);
}

void SurfaceDrawer::DrawSky(const GpuSurfaces& surfaces, const PreviewView& view) const {
  if (!surfaces.environment) return;
  if (!sky_) {
    sky_ = std::make_unique<ShaderProgram>("the environment", SkyVertexShader().c_str(), SkyFragmentShader().c_str());
    sky_->Use();
    glUniform1i((*sky_)["environment"], environment_unit);
  }
  UseView(*sky_, surfaces, view);
  glUniform3fv((*sky_)["directions"], 3, view.directions[0].data());
  glBindVertexArray(nothing_.Name());
  glDisable(GL_DEPTH_TEST);  // also disables depth writes
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
  Set(program, "kt", m.kt);
  Set(program, "exponent", m.n);
  constexpr double rim = 0.25;  // brightness at the rim of a full mirror that reflects nothing
  Set(program, "rim", rim * std::max(Luminance(m.kr), Luminance(m.kt)));
  glUniform2f(program["texture_scale"], static_cast<float>(m.texture_scale.x), static_cast<float>(m.texture_scale.y));
  glUniform1i(program["is_painted"], m.texture ? 1 : 0);
  glUniform1i(program["is_ambient_painted"], m.texture_multiplies_ambient ? 1 : 0);
  if (m.texture) glBindTexture(GL_TEXTURE_2D, surfaces.textures.at(m.texture.get()).Name());
}

void SurfaceDrawer::UseLights(const ShaderProgram& program, const GpuSurfaces& surfaces, const PreviewView& view,
                              bool shadows) const {
  Set(program, "around", surfaces.around);
  if (shadows) {
    glActiveTexture(GL_TEXTURE0 + shadows_unit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, surfaces.shadow_maps->Name());
    glActiveTexture(GL_TEXTURE0);
    SetMatrices(program["shadow_views"], surfaces.shadow_views);
    glUniform1i(program["shadow_count"], static_cast<GLint>(surfaces.shadow_views.size()));
  }
  glBindBufferBase(GL_UNIFORM_BUFFER, lights_binding, surfaces.lights.Name());
  const bool has_head_light = surfaces.preview_lights.head_light;
  if (has_head_light) {
    const GpuLight at_eye = AsGpu({.color = {1, 1, 1}, .place = view.eye});
    glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof(at_eye), &at_eye);
  }
  glUniform1i(program["light_count"], has_head_light ? 1 : static_cast<GLint>(surfaces.preview_lights.lights.size()));
}

void SurfaceDrawer::Draw(GpuSurfaces& surfaces, const ClipMatrix& clip_from_drawing, const PreviewView& view,
                         bool shadows) const {
  if (surfaces.batches.empty()) return;
  if (shadows) DrawShadows(surfaces);
  const bool encodes = view.exposure.srgb && CanEncodeSrgb();
  if (encodes) glEnable(GL_FRAMEBUFFER_SRGB);
  // Moved back slightly, by their slope and the smallest step of depth, so that lines on them are visible.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 1);
  glEnable(GL_DEPTH_CLAMP);  // infinite shapes continue behind the farthest depth
  glDisable(GL_BLEND);
  glBindVertexArray(surfaces.shaded.Name());
  SurfaceFeatures features{surfaces.has_colors || !surfaces.textures.empty(), surfaces.environment.has_value(), false,
                           shadows && surfaces.shadow_maps};
  const ShaderProgram* program = nullptr;
  for (const SurfaceBatch& batch : surfaces.batches) {
    if (!program || Mirrors(batch) != features.mirrors) {
      features.mirrors = Mirrors(batch);
      program = &ProgramFor(features);
      UseView(*program, surfaces, view);
      if (encodes) glUniform1i((*program)["srgb"], 0);
      SetMatrix((*program)["clip_from_drawing"], clip_from_drawing);
      glUniform3fv((*program)["eye"], 1, view.eye.data());
      UseLights(*program, surfaces, view, features.shadows);
      glUniform1i((*program)["has_colors"], surfaces.has_colors ? 1 : 0);
    }
    UseMaterial(*program, surfaces, batch.material);
    batch.is_clear ? DrawClear(batch) : DrawOpaque(batch);
  }
  glDisable(GL_DEPTH_CLAMP);
  if (encodes) glDisable(GL_FRAMEBUFFER_SRGB);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glEnable(GL_BLEND);
  UseAlpha();
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
  glBindVertexArray(surfaces.plain.Name());
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  for (const SurfaceBatch& batch : surfaces.batches) DrawTriangles(batch);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

}  // namespace ray
