#include "source/view/gl/ListDrawer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

#include "source/view/contexts/Context.h"

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
uniform float alpha;
out vec4 color;
void main() { color = vec4(vertex_color.rgb, vertex_color.a * alpha); }
)";

constexpr GLuint at_location = 0, color_location = 1;

const void* Offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

GLsizeiptr Bytes(const auto& list) { return static_cast<GLsizeiptr>(list.size() * sizeof(list[0])); }

/// Describes the vertices in the buffer bound, for the array bound.
void Describe(bool with_colors) {
  constexpr GLsizei stride = sizeof(Vertex);
  glEnableVertexAttribArray(at_location);
  glVertexAttribPointer(at_location, 3, GL_FLOAT, GL_FALSE, stride, Offset(offsetof(Vertex, at)));
  if (!with_colors) return;
  glEnableVertexAttribArray(color_location);
  glVertexAttribPointer(color_location, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, Offset(offsetof(Vertex, color)));
}

void CheckMemory() {
  if (glGetError() == GL_OUT_OF_MEMORY) throw ContextError("out of GPU memory");
}

}  // namespace

ListDrawer::ListDrawer() : program_("lists", vertex_shader, fragment_shader) {
  std::array<GLfloat, 2> range{1, 1};
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range.data());
  widest_ = range[1];
}

std::shared_ptr<GpuTriangles> ListDrawer::Upload(const Triangles& triangles) const {
  auto uploaded = std::make_shared<GpuTriangles>();
  uploaded->opaque = static_cast<GLsizei>(triangles.opaque.size());
  uploaded->clear = static_cast<GLsizei>(triangles.clear.size());
  std::vector<std::uint32_t> indices = triangles.opaque;
  indices.insert(indices.end(), triangles.clear.begin(), triangles.clear.end());
  assert(std::all_of(indices.begin(), indices.end(), [&](auto i) { return i < triangles.vertices.size(); }));
  glBindVertexArray(uploaded->colored.Name());  // indices belong to the array bound when they come
  glBindBuffer(GL_ARRAY_BUFFER, uploaded->vertices.Name());
  glBufferData(GL_ARRAY_BUFFER, Bytes(triangles.vertices), triangles.vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, uploaded->indices.Name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, Bytes(indices), indices.data(), GL_STATIC_DRAW);
  Describe(true);
  glBindVertexArray(uploaded->plain.Name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, uploaded->indices.Name());
  Describe(false);
  CheckMemory();
  return uploaded;
}

std::shared_ptr<GpuLines> ListDrawer::Upload(const Lines& lines) const {
  auto uploaded = std::make_shared<GpuLines>();
  uploaded->count = static_cast<GLsizei>(lines.size());
  glBindVertexArray(uploaded->colored.Name());
  glBindBuffer(GL_ARRAY_BUFFER, uploaded->vertices.Name());
  glBufferData(GL_ARRAY_BUFFER, Bytes(lines), lines.data(), GL_STATIC_DRAW);
  Describe(true);
  CheckMemory();
  return uploaded;
}

void ListDrawer::Start(const ClipMatrix& clip_from_drawing, double alpha) const {
  program_.Use();
  SetMatrix(program_["clip_from_drawing"], clip_from_drawing);
  glUniform1f(program_["alpha"], static_cast<float>(alpha));
}

void ListDrawer::Draw(const GpuTriangles& triangles, const ClipMatrix& clip_from_drawing) const {
  Start(clip_from_drawing, 1);
  glBindVertexArray(triangles.colored.Name());
  // Moved back a little, by their slope and the smallest step of depth, so that lines on them are seen.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 1);
  if (triangles.opaque > 0) {
    glDisable(GL_BLEND);
    glDrawElements(GL_TRIANGLES, triangles.opaque, GL_UNSIGNED_INT, Offset(0));
    glEnable(GL_BLEND);
  }
  if (triangles.clear > 0) {
    glDepthMask(GL_FALSE);
    glDrawElements(GL_TRIANGLES, triangles.clear, GL_UNSIGNED_INT,
                   Offset(static_cast<std::size_t>(triangles.opaque) * sizeof(std::uint32_t)));
    glDepthMask(GL_TRUE);
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void ListDrawer::Draw(const GpuLines& lines, const ClipMatrix& clip_from_drawing, double width, double hidden) const {
  if (lines.count == 0) return;
  glBindVertexArray(lines.colored.Name());
  glLineWidth(std::clamp(static_cast<float>(width), 1.0F, widest_));
  // What is hidden comes first: the lines that are seen would hide others of the list.
  if (hidden > 0) {
    Start(clip_from_drawing, hidden);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
    glDrawArrays(GL_LINES, 0, lines.count);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LEQUAL);
  }
  Start(clip_from_drawing, 1);
  glDrawArrays(GL_LINES, 0, lines.count);
  glLineWidth(1);
}

void ListDrawer::DrawEdges(const GpuTriangles& triangles, const ClipMatrix& clip_from_drawing,
                           const Rgba& color) const {
  const GLsizei count = triangles.opaque + triangles.clear;
  if (count == 0) return;
  Start(clip_from_drawing, 1);
  glBindVertexArray(triangles.plain.Name());
  const auto channel = [&](std::size_t i) { return static_cast<float>(color[i]) / 255.0F; };
  glVertexAttrib4f(color_location, channel(0), channel(1), channel(2), channel(3));
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, Offset(0));
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

}  // namespace ray
