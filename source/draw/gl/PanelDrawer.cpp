#include "source/draw/gl/PanelDrawer.h"

#include <cstddef>

#include "source/draw/gl/Objects.h"

namespace ray {
namespace {

constexpr const char* vertex_shader = R"(#version 330 core
layout(location = 0) in vec2 at;        // pixels from the upper left corner
layout(location = 1) in vec2 on_sheet;  // 0..1
layout(location = 2) in vec4 color;
uniform vec2 size;
out vec2 uv;
out vec4 ink;
void main() {
  gl_Position = vec4(2.0 * at.x / size.x - 1.0, 1.0 - 2.0 * at.y / size.y, 0, 1);
  uv = on_sheet;
  ink = color;
}
)";

constexpr const char* fragment_shader = R"(#version 330 core
in vec2 uv;
in vec4 ink;
uniform sampler2D sheet;
out vec4 color;
void main() {
  float covered = texelFetch(sheet, ivec2(uv * vec2(textureSize(sheet, 0))), 0).r;
  color = vec4(ink.rgb, ink.a * covered);
}
)";

}  // namespace

PanelDrawer::Gpu::Gpu() : program("panels", vertex_shader, fragment_shader) {
  using Corner = PanelDrawing::Corner;
  glBindVertexArray(vertex_array.Name());
  glBindBuffer(GL_ARRAY_BUFFER, corners.Name());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.Name());
  Describe(0, 2, GL_FLOAT, sizeof(Corner), offsetof(Corner, x));
  Describe(1, 2, GL_FLOAT, sizeof(Corner), offsetof(Corner, u));
  Describe(2, 4, GL_UNSIGNED_BYTE, sizeof(Corner), offsetof(Corner, color));
}

void PanelDrawer::Gpu::Upload(const InkSheet& letters) {
  glBindTexture(GL_TEXTURE_2D, sheet.Name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, letters.width, letters.height, 0, GL_RED, GL_UNSIGNED_BYTE, letters.ink.data());
  ReadFirstLevel(GL_TEXTURE_2D, GL_NEAREST);
}

void PanelDrawer::Draw(const PanelDrawing& panels, const Canvas& canvas) {
  if (panels.indices.empty()) return;
  if (!gpu_) gpu_.emplace();
  if (sheet_ != panels.sheet) gpu_->Upload(*panels.sheet);
  sheet_ = panels.sheet;
  gpu_->program.Use();
  glUniform2f(gpu_->program["size"], static_cast<float>(canvas.Width()), static_cast<float>(canvas.Height()));
  glUniform1i(gpu_->program["sheet"], 0);
  glBindTexture(GL_TEXTURE_2D, gpu_->sheet.Name());
  glBindVertexArray(gpu_->vertex_array.Name());
  glBindBuffer(GL_ARRAY_BUFFER, gpu_->corners.Name());
  glBufferData(GL_ARRAY_BUFFER, Bytes(panels.corners), panels.corners.data(), GL_STREAM_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, Bytes(panels.indices), panels.indices.data(), GL_STREAM_DRAW);
  CheckMemory();
  canvas.UseWhole();
  glDisable(GL_DEPTH_TEST);
  for (const PanelDrawing::Part& part : panels.parts) {
    glScissor(part.left, canvas.Height() - part.bottom, part.right - part.left, part.bottom - part.top);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(part.count), GL_UNSIGNED_INT,
                   Offset(part.first * sizeof(panels.indices[0])));
  }
  glEnable(GL_DEPTH_TEST);
  canvas.UseViewport();
}

}  // namespace ray
