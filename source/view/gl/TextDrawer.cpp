#include "source/view/gl/TextDrawer.h"

#include <cmath>
#include <cstddef>

#include "source/text/Font.h"
#include "source/view/gl/Upload.h"

namespace ray {

namespace {

constexpr const char* vertex_shader = R"(#version 330 core
layout(location = 0) in vec2 at;      // pixels
layout(location = 1) in vec2 on_sheet;  // pixels
layout(location = 2) in vec4 color;
uniform vec2 size;
out vec2 texel;
out vec4 ink;
void main() {
  gl_Position = vec4(2.0 * at / size - 1.0, 0, 1);
  texel = on_sheet;
  ink = color;
}
)";

constexpr const char* fragment_shader = R"(#version 330 core
in vec2 texel;
in vec4 ink;
uniform sampler2D sheet;
out vec4 color;
void main() {
  // Left of the sheet is the ground.
  if (texel.x >= 0.0 && texelFetch(sheet, ivec2(texel), 0).r < 0.5) discard;
  color = ink;
}
)";

constexpr float ground_margin = 2;  // pixels

struct TextVertex {
  float x, y;
  float sheet_x, sheet_y;
  Rgba color;
};

struct Rectangle {
  float x, y, width, height;
};

void Add(std::vector<TextVertex>& vertices, const Rectangle& at, const Rectangle& on_sheet, const Rgba& color) {
  const auto corner = [&](float i, float j) {
    return TextVertex{at.x + i * at.width, at.y + j * at.height, on_sheet.x + i * on_sheet.width,
                      on_sheet.y + j * on_sheet.height, color};
  };
  for (const TextVertex& v : {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 0), corner(1, 1), corner(0, 1)})
    vertices.push_back(v);
}

void Add(std::vector<TextVertex>& vertices, const Label& label, float size) {
  // Whole pixels, so that a pixel of the font is one of the drawing.
  const auto left = static_cast<float>(std::floor(label.x + 0.5)),
             bottom = static_cast<float>(std::floor(label.y + 0.5));
  std::vector<int> glyphs;
  for (char byte : label.text)
    if (const int glyph = GlyphOf(byte); glyph >= 0) glyphs.push_back(glyph);
  if (glyphs.empty()) return;
  const float width = static_cast<float>(glyphs.size()) * glyph_width * size, margin = ground_margin * size;
  const auto alpha = static_cast<std::uint8_t>(Label::ground_alpha * label.color[3] / 255);
  Add(vertices, {left - margin, bottom, width + 2 * margin, glyph_height * size}, {-2, 0, 1, 1}, {0, 0, 0, alpha});
  float x = left;
  for (int glyph : glyphs) {
    Add(vertices, {x, bottom, glyph_width * size, glyph_height * size},
        {static_cast<float>(glyph * glyph_width), 0, glyph_width, glyph_height}, label.color);
    x += glyph_width * size;
  }
}

}  // namespace

TextDrawer::TextDrawer() : program_("text", vertex_shader, fragment_shader) {
  glBindVertexArray(vertex_array_.Name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.Name());
  Describe(0, 2, GL_FLOAT, sizeof(TextVertex), offsetof(TextVertex, x));
  Describe(1, 2, GL_FLOAT, sizeof(TextVertex), offsetof(TextVertex, sheet_x));
  Describe(2, 4, GL_UNSIGNED_BYTE, sizeof(TextVertex), offsetof(TextVertex, color));
  glBindTexture(GL_TEXTURE_2D, sheet_.Name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, glyph_count * glyph_width, glyph_height, 0, GL_RED, GL_UNSIGNED_BYTE,
               GlyphSheet().data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

void TextDrawer::Draw(std::span<const Label> labels, const Canvas& canvas, int size) const {
  std::vector<TextVertex> vertices;
  for (const Label& label : labels) Add(vertices, label, static_cast<float>(size));
  if (vertices.empty()) return;
  program_.Use();
  glUniform2f(program_["size"], static_cast<float>(canvas.Width()), static_cast<float>(canvas.Height()));
  glUniform1i(program_["sheet"], 0);
  glBindTexture(GL_TEXTURE_2D, sheet_.Name());
  glBindVertexArray(vertex_array_.Name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.Name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(TextVertex)), vertices.data(),
               GL_STREAM_DRAW);
  canvas.UseWhole();
  glDisable(GL_DEPTH_TEST);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
  glEnable(GL_DEPTH_TEST);
  canvas.UseViewport();
}

}  // namespace ray
