#include "source/draw/gl/PictureDrawer.h"

#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <string>

#include "R2/Color.h"
#include "R2/ImageFile.h"
#include "source/draw/contexts/Context.h"

namespace ray {

namespace {

constexpr const char* vertex_shader = R"(#version 330 core
uniform vec3 corners[4];
uniform mat4 clip_from_drawing;
out vec2 uv;
void main() {
  // The corners go round, a strip goes to and fro.
  int corner = gl_VertexID < 2 ? gl_VertexID : 5 - gl_VertexID;
  uv = vec2(corner == 1 || corner == 2, corner >= 2);
  gl_Position = clip_from_drawing * vec4(corners[corner], 1);
}
)";

// The byte a channel is shown as is guessed with the curve, then set right by the table of where bytes begin: what is
// seen is what an image file would hold, whatever the driver's pow() is worth.
constexpr const char* fragment_shader = R"(#version 330 core
in vec2 uv;
uniform sampler2D picture;
uniform sampler2D steps;
uniform float exposure;
uniform float alpha;
uniform int srgb;
uniform int rows;
out vec4 color;

float Shown(float linear) {
  if (!(linear > 0.0)) return 0.0;
  linear = min(linear, 1.0);
  float encoded = srgb == 0 ? linear : linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
  int guess = clamp(int(encoded * 255.0 + 0.5), 0, 255);
  if (linear < texelFetch(steps, ivec2(guess, srgb), 0).r) --guess;
  else if (guess < 255 && linear >= texelFetch(steps, ivec2(guess + 1, srgb), 0).r) ++guess;
  return float(guess) / 255.0;
}

void main() {
  ivec2 size = textureSize(picture, 0);
  ivec2 texel = clamp(ivec2(floor(uv * vec2(size))), ivec2(0), size - 1);
  if (texel.y >= rows) discard;
  vec3 light = exposure * texelFetch(picture, texel, 0).rgb;
  color = vec4(Shown(light.r), Shown(light.g), Shown(light.b), alpha);
}
)";

constexpr GLint picture_unit = 0, steps_unit = 1;

/// The least float that is written as `byte` or more. The bits of positive floats are in the order of their values.
float FirstOf(int byte, bool srgb) {
  if (byte == 0) return 0;
  const auto reaches = [&](float linear) {
    return R2::ToByte(srgb ? R2::EncodeSrgb(double{linear}) : double{linear}) >= byte;
  };
  auto below = std::bit_cast<std::uint32_t>(0.0F), reached = std::bit_cast<std::uint32_t>(1.0F);
  while (reached - below > 1) {
    const std::uint32_t middle = below + (reached - below) / 2;
    (reaches(std::bit_cast<float>(middle)) ? reached : below) = middle;
  }
  return std::bit_cast<float>(reached);
}

void UseNearest() { ReadFirstLevel(GL_TEXTURE_2D, GL_NEAREST); }

}  // namespace

PictureDrawer::PictureDrawer() : program_("pictures", vertex_shader, fragment_shader) {
  std::array<float, 512> steps{};
  for (int byte = 0; byte < 256; ++byte)
    for (int srgb : {0, 1}) steps[static_cast<std::size_t>(srgb * 256 + byte)] = FirstOf(byte, srgb == 1);
  glBindTexture(GL_TEXTURE_2D, steps_.Name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, 256, 2, 0, GL_RED, GL_FLOAT, steps.data());
  UseNearest();
}

std::shared_ptr<GpuPicture> PictureDrawer::Make(int width, int height) const {
  assert(width >= 1 && height >= 1);
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (width > most || height > most)
    throw ContextError("cannot show an image of " + std::to_string(width) + " x " + std::to_string(height) +
                       " pixels; the GPU allows " + std::to_string(most) + " per side");
  auto picture = std::make_shared<GpuPicture>();
  picture->width = width, picture->height = height;
  glBindTexture(GL_TEXTURE_2D, picture->texture.Name());
  const std::vector<float> black(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, width, height, 0, GL_RGB, GL_FLOAT, black.data());
  UseNearest();
  if (glGetError() == GL_OUT_OF_MEMORY) throw ContextError("out of GPU memory");
  return picture;
}

void PictureDrawer::Update(GpuPicture& picture, int first, int count, std::span<const float> rgb) const {
  if (count == 0) return;
  assert(first >= 0 && count > 0 && first + count <= picture.height);
  assert(rgb.size() == 3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(count));
  glBindTexture(GL_TEXTURE_2D, picture.texture.Name());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, first, picture.width, count, GL_RGB, GL_FLOAT, rgb.data());
}

void PictureDrawer::Draw(const GpuPicture& picture, const std::array<std::array<float, 3>, 4>& corners,
                         const ClipMatrix& clip_from_drawing, const PictureLook& look) const {
  program_.Use();
  SetMatrix(program_["clip_from_drawing"], clip_from_drawing);
  glUniform3fv(program_["corners"], 4, corners[0].data());
  glUniform1f(program_["exposure"], static_cast<float>(look.exposure));
  glUniform1f(program_["alpha"], static_cast<float>(look.alpha));
  glUniform1i(program_["srgb"], look.srgb ? 1 : 0);
  glUniform1i(program_["rows"], look.rows < 0 ? std::numeric_limits<GLint>::max() : look.rows);
  glUniform1i(program_["picture"], picture_unit);
  glUniform1i(program_["steps"], steps_unit);
  glActiveTexture(GL_TEXTURE0 + steps_unit);
  glBindTexture(GL_TEXTURE_2D, steps_.Name());
  glActiveTexture(GL_TEXTURE0 + picture_unit);
  glBindTexture(GL_TEXTURE_2D, picture.texture.Name());
  glBindVertexArray(nothing_.Name());
  glDepthMask(look.alpha >= 1);  // what is behind it is seen through it, whenever it is drawn
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDepthMask(GL_TRUE);
}

void PictureDrawer::DrawFlat(const GpuPicture& picture, const std::array<std::array<float, 3>, 4>& corners,
                             const PictureLook& look) const {
  constexpr ClipMatrix as_it_is{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  glDisable(GL_DEPTH_TEST);  // which leaves depth unwritten as well
  Draw(picture, corners, as_it_is, look);
  glEnable(GL_DEPTH_TEST);
}

void PictureDrawer::Draw(const GpuPicture& picture, const PictureLook& look) const {
  DrawFlat(picture, {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}, look);
}

}  // namespace ray
