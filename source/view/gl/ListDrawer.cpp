#include "source/view/gl/ListDrawer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

namespace ray {

namespace {

constexpr const char* vertex_shader = R"(#version 330 core
layout(location = 0) in vec3 at;
layout(location = 1) in vec4 color;
uniform mat4 clip_from_drawing;
out vec4 vertex_color;
void main() {
  gl_Position = clip_from_drawing * vec4(at, 1);
  vertex_color = color;
}
)";

constexpr const char* fragment_shader = R"(#version 330 core
in vec4 vertex_color;
uniform float cover;
out vec4 color;
void main() { color = vec4(vertex_color.rgb, vertex_color.a * cover); }
)";

constexpr GLuint at_location = 0, color_location = 1;

const void* Offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

GLsizeiptr Bytes(const auto& list) { return static_cast<GLsizeiptr>(list.size() * sizeof(list[0])); }

/// Describes the vertices in the buffer bound, for the array bound.
void Describe(const Functions& gl, bool with_colors) {
  constexpr GLsizei stride = sizeof(Vertex);
  gl.EnableVertexAttribArray(at_location);
  gl.VertexAttribPointer(at_location, 3, GL_FLOAT, GL_FALSE, stride, Offset(offsetof(Vertex, at)));
  if (!with_colors) return;
  gl.EnableVertexAttribArray(color_location);
  gl.VertexAttribPointer(color_location, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, Offset(offsetof(Vertex, color)));
}

void CheckMemory(const Functions& gl) {
  if (gl.GetError() == GL_OUT_OF_MEMORY) throw ContextError("the memory of the graphics is full");
}

}  // namespace

ListDrawer::ListDrawer(std::shared_ptr<const Functions> gl)
    : gl_(std::move(gl)), program_(gl_, "lists", vertex_shader, fragment_shader) {
  std::array<GLfloat, 2> range{1, 1};
  gl_->GetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range.data());
  widest_ = range[1];
}

std::shared_ptr<GpuTriangles> ListDrawer::Keep(const Triangles& triangles) const {
  auto kept = std::make_shared<GpuTriangles>(gl_);
  kept->opaque = static_cast<GLsizei>(triangles.opaque.size());
  kept->clear = static_cast<GLsizei>(triangles.clear.size());
  std::vector<std::uint32_t> indices = triangles.opaque;
  indices.insert(indices.end(), triangles.clear.begin(), triangles.clear.end());
  assert(std::all_of(indices.begin(), indices.end(), [&](auto i) { return i < triangles.vertices.size(); }));
  gl_->BindVertexArray(kept->colored.Name());  // indices belong to the array bound when they come
  gl_->BindBuffer(GL_ARRAY_BUFFER, kept->vertices.Name());
  gl_->BufferData(GL_ARRAY_BUFFER, Bytes(triangles.vertices), triangles.vertices.data(), GL_STATIC_DRAW);
  gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, kept->indices.Name());
  gl_->BufferData(GL_ELEMENT_ARRAY_BUFFER, Bytes(indices), indices.data(), GL_STATIC_DRAW);
  Describe(*gl_, true);
  gl_->BindVertexArray(kept->plain.Name());
  gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, kept->indices.Name());
  Describe(*gl_, false);
  CheckMemory(*gl_);
  return kept;
}

std::shared_ptr<GpuLines> ListDrawer::Keep(const Lines& lines) const {
  auto kept = std::make_shared<GpuLines>(gl_);
  kept->count = static_cast<GLsizei>(lines.size());
  gl_->BindVertexArray(kept->colored.Name());
  gl_->BindBuffer(GL_ARRAY_BUFFER, kept->vertices.Name());
  gl_->BufferData(GL_ARRAY_BUFFER, Bytes(lines), lines.data(), GL_STATIC_DRAW);
  Describe(*gl_, true);
  CheckMemory(*gl_);
  return kept;
}

void ListDrawer::Start(const ClipMatrix& clip_from_drawing, double cover) const {
  program_.Use();
  SetMatrix(*gl_, program_["clip_from_drawing"], clip_from_drawing);
  gl_->Uniform1f(program_["cover"], static_cast<float>(cover));
}

void ListDrawer::Draw(const GpuTriangles& triangles, const ClipMatrix& clip_from_drawing) const {
  Start(clip_from_drawing, 1);
  gl_->BindVertexArray(triangles.colored.Name());
  // Moved back a little, by their slope and the smallest step of depth, so that lines on them are seen.
  gl_->Enable(GL_POLYGON_OFFSET_FILL);
  gl_->PolygonOffset(1, 1);
  if (triangles.opaque > 0) {
    gl_->Disable(GL_BLEND);
    gl_->DrawElements(GL_TRIANGLES, triangles.opaque, GL_UNSIGNED_INT, Offset(0));
    gl_->Enable(GL_BLEND);
  }
  if (triangles.clear > 0) {
    gl_->DepthMask(GL_FALSE);
    gl_->DrawElements(GL_TRIANGLES, triangles.clear, GL_UNSIGNED_INT,
                      Offset(static_cast<std::size_t>(triangles.opaque) * sizeof(std::uint32_t)));
    gl_->DepthMask(GL_TRUE);
  }
  gl_->Disable(GL_POLYGON_OFFSET_FILL);
}

void ListDrawer::Draw(const GpuLines& lines, const ClipMatrix& clip_from_drawing, double width, double hidden) const {
  if (lines.count == 0) return;
  gl_->BindVertexArray(lines.colored.Name());
  gl_->LineWidth(std::clamp(static_cast<float>(width), 1.0F, widest_));
  // What is hidden comes first: the lines that are seen would hide others of the list.
  if (hidden > 0) {
    Start(clip_from_drawing, hidden);
    gl_->DepthFunc(GL_GREATER);
    gl_->DepthMask(GL_FALSE);
    gl_->DrawArrays(GL_LINES, 0, lines.count);
    gl_->DepthMask(GL_TRUE);
    gl_->DepthFunc(GL_LEQUAL);
  }
  Start(clip_from_drawing, 1);
  gl_->DrawArrays(GL_LINES, 0, lines.count);
  gl_->LineWidth(1);
}

void ListDrawer::DrawEdges(const GpuTriangles& triangles, const ClipMatrix& clip_from_drawing,
                           const Rgba& color) const {
  const GLsizei count = triangles.opaque + triangles.clear;
  if (count == 0) return;
  Start(clip_from_drawing, 1);
  gl_->BindVertexArray(triangles.plain.Name());
  const auto channel = [&](std::size_t i) { return static_cast<float>(color[i]) / 255.0F; };
  gl_->VertexAttrib4f(color_location, channel(0), channel(1), channel(2), channel(3));
  gl_->PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl_->DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, Offset(0));
  gl_->PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

}  // namespace ray
