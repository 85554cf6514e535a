#include "source/draw/gl/ListDrawer.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "source/draw/gl/Objects.h"

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

}  // namespace

ListDrawer::ListDrawer() : program_("lists", vertex_shader, fragment_shader) {
  std::array<GLfloat, 2> range{1, 1};
  glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range.data());
  widest_ = range[1];
}

std::shared_ptr<GpuLines> ListDrawer::Upload(const Lines& lines) const {
  auto uploaded = std::make_shared<GpuLines>();
  uploaded->count = static_cast<GLsizei>(lines.size());
  glBindVertexArray(uploaded->colored.Name());
  glBindBuffer(GL_ARRAY_BUFFER, uploaded->vertices.Name());
  glBufferData(GL_ARRAY_BUFFER, Bytes(lines), lines.data(), GL_STATIC_DRAW);
  Describe(at_location, 3, GL_FLOAT, sizeof(Vertex), offsetof(Vertex, at));
  Describe(color_location, 4, GL_UNSIGNED_BYTE, sizeof(Vertex), offsetof(Vertex, color));
  CheckMemory();
  return uploaded;
}

void ListDrawer::Start(const ClipMatrix& clip_from_drawing, double alpha) const {
  program_.Use();
  SetMatrix(program_["clip_from_drawing"], clip_from_drawing);
  glUniform1f(program_["alpha"], static_cast<float>(alpha));
}

void ListDrawer::Draw(const GpuLines& lines, const ClipMatrix& clip_from_drawing, double width, double hidden) const {
  if (lines.count == 0) return;
  glBindVertexArray(lines.colored.Name());
  glLineWidth(std::clamp(static_cast<float>(width), 1.0F, widest_));
  // Hidden lines are drawn first, since visible ones would hide others of the list.
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

}  // namespace ray
