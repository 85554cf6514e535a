#include "source/draw/gl/ImageDrawer.h"

#include <bit>
#include <cassert>
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
  // The corners are in circular order, a strip in zigzag order.
  int corner = gl_VertexID < 2 ? gl_VertexID : 5 - gl_VertexID;
  uv = vec2(corner == 1 || corner == 2, corner >= 2);
  gl_Position = clip_from_drawing * vec4(corners[corner], 1);
}
)";

// The displayed byte of a channel is estimated with the curve, then corrected by the table of where bytes begin: the
// screen shows the bytes of an image file, regardless of the accuracy of the driver's pow().
constexpr const char* fragment_shader = R"(#version 330 core
in vec2 uv;
uniform sampler2D pixels;
uniform sampler2D steps;
uniform float exposure;
uniform float alpha;
uniform int srgb, bytes;  // bytes: a row of steps
uniform int rows;
out vec4 color;

float Shown(float linear) {
  if (!(linear > 0.0)) return 0.0;
  linear = min(linear, 1.0);
  float encoded = srgb == 0 ? linear : linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
  int guess = clamp(int(encoded * 255.0 + 0.5), 0, 255);
  if (linear < texelFetch(steps, ivec2(guess, bytes), 0).r) --guess;
  else if (guess < 255 && linear >= texelFetch(steps, ivec2(guess + 1, bytes), 0).r) ++guess;
  return float(guess) / 255.0;
}

void main() {
  ivec2 size = textureSize(pixels, 0);
  ivec2 texel = clamp(ivec2(floor(uv * vec2(size))), ivec2(0), size - 1);
  if (texel.y >= rows) discard;
  vec3 light = exposure * texelFetch(pixels, texel, 0).rgb;
  color = vec4(Shown(light.r), Shown(light.g), Shown(light.b), alpha);
}
)";

constexpr const char* depths_vertex_shader = R"(#version 330 core
uniform vec3 directions[3];  // to the lower left corner; from there to the right edge, and to the upper one
out vec2 uv;
out vec3 direction;
void main() {
  uv = vec2(gl_VertexID == 1 ? 2 : 0, gl_VertexID == 2 ? 2 : 0);
  direction = directions[0] + uv.x * directions[1] + uv.y * directions[2];
  gl_Position = vec4(2.0 * uv - 1.0, 0, 1);
}
)";

constexpr const char* depths_fragment_shader = R"(#version 330 core
in vec2 uv;
in vec3 direction;
uniform sampler2D pixels;
uniform vec3 eye;
uniform float unit;
uniform mat4 clip_from_drawing;
void main() {
  float distance = texture(pixels, uv).r / unit;
  // Offset by the slope of the surface over a pixel, except at outlines, where that is a jump, limited to 2%; plus
  // 1e-3, 16 steps of a depth buffer of 24 bits whose nearest depth is 1e-3 of the farthest. So lines on a surface are
  // visible.
  float behind = distance + min(fwidth(distance), 0.02 * distance) + 1e-3 * distance;
  vec4 clip = clip_from_drawing * vec4(eye + behind * normalize(direction), 1);
  gl_FragDepth = distance > 0.0 ? clamp(0.5 * clip.z / clip.w + 0.5, 0.0, 1.0) : 1.0;
}
)";

constexpr GLint image_unit = 0, steps_unit = 1;

/// Returns the least float that is written as `byte` or more. The bits of positive floats have the order of their
/// values.
float FirstOf(int byte, bool srgb, R2::Quantization how) {
  if (byte == 0) return 0;
  const auto reaches = [&](float linear) {
    return R2::ToByte(srgb ? R2::EncodeSrgb(double{linear}) : double{linear}, how) >= byte;
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

ImageDrawer::ImageDrawer() : program_("images", vertex_shader, fragment_shader) {
  std::array<float, 1024> steps{};
  for (const auto how : {R2::Quantization::rounded, R2::Quantization::truncated})
    for (int byte = 0; byte < 256; ++byte)
      for (int srgb : {0, 1})
        steps[static_cast<std::size_t>((2 * static_cast<int>(how) + srgb) * 256 + byte)] =
            FirstOf(byte, srgb == 1, how);
  glBindTexture(GL_TEXTURE_2D, steps_.Name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, 256, 4, 0, GL_RED, GL_FLOAT, steps.data());
  UseNearest();
}

std::shared_ptr<GpuImage> ImageDrawer::Make(int width, int height) const {
  assert(width >= 1 && height >= 1);
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (width > most || height > most)
    throw ContextError("cannot show an image of " + std::to_string(width) + " x " + std::to_string(height) +
                       " pixels; the GPU allows " + std::to_string(most) + " per side");
  auto image = std::make_shared<GpuImage>();
  image->width = width, image->height = height;
  glBindTexture(GL_TEXTURE_2D, image->texture.Name());
  const std::vector<float> black(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, width, height, 0, GL_RGB, GL_FLOAT, black.data());
  UseNearest();
  if (glGetError() == GL_OUT_OF_MEMORY) throw ContextError("out of GPU memory");
  return image;
}

void ImageDrawer::Update(GpuImage& image, int first, int count, std::span<const float> rgb) const {
  if (count == 0) return;
  assert(first >= 0 && count > 0 && first + count <= image.height);
  assert(rgb.size() == 3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(count));
  glBindTexture(GL_TEXTURE_2D, image.texture.Name());
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, first, image.width, count, GL_RGB, GL_FLOAT, rgb.data());
}

void ImageDrawer::Draw(const GpuImage& image, const std::array<std::array<float, 3>, 4>& corners,
                       const ClipMatrix& clip_from_drawing, const ImageLook& look) const {
  program_.Use();
  SetMatrix(program_["clip_from_drawing"], clip_from_drawing);
  glUniform3fv(program_["corners"], 4, corners[0].data());
  glUniform1f(program_["exposure"], static_cast<float>(look.exposure));
  glUniform1f(program_["alpha"], static_cast<float>(look.alpha));
  glUniform1i(program_["srgb"], look.srgb ? 1 : 0);
  glUniform1i(program_["bytes"], (look.truncated ? 2 : 0) + (look.srgb ? 1 : 0));
  glUniform1i(program_["rows"], look.rows < 0 ? std::numeric_limits<GLint>::max() : look.rows);
  glUniform1i(program_["pixels"], image_unit);
  glUniform1i(program_["steps"], steps_unit);
  glActiveTexture(GL_TEXTURE0 + steps_unit);
  glBindTexture(GL_TEXTURE_2D, steps_.Name());
  glActiveTexture(GL_TEXTURE0 + image_unit);
  glBindTexture(GL_TEXTURE_2D, image.texture.Name());
  glBindVertexArray(nothing_.Name());
  glDepthMask(look.alpha >= 1);  // its background stays visible, in any order of drawing
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDepthMask(GL_TRUE);
}

void ImageDrawer::DrawFlat(const GpuImage& image, const std::array<std::array<float, 3>, 4>& corners,
                           const ImageLook& look) const {
  constexpr ClipMatrix as_it_is{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  glDisable(GL_DEPTH_TEST);  // also disables depth writes
  Draw(image, corners, as_it_is, look);
  glEnable(GL_DEPTH_TEST);
}

void ImageDrawer::DrawDepths(const GpuImage& distances, const PreviewView& view, const ClipMatrix& clip_from_drawing,
                             double unit) const {
  if (!depths_)
    depths_ = std::make_unique<ShaderProgram>("depths of images", depths_vertex_shader, depths_fragment_shader);
  depths_->Use();
  glUniform1i((*depths_)["pixels"], image_unit);
  glUniform3fv((*depths_)["directions"], 3, view.directions[0].data());
  glUniform3fv((*depths_)["eye"], 1, view.eye.data());
  glUniform1f((*depths_)["unit"], AsFloat(unit));
  SetMatrix((*depths_)["clip_from_drawing"], clip_from_drawing);
  glActiveTexture(GL_TEXTURE0 + image_unit);
  glBindTexture(GL_TEXTURE_2D, distances.texture.Name());
  glBindVertexArray(nothing_.Name());
  glDepthFunc(GL_ALWAYS);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthFunc(GL_LEQUAL);
}

void ImageDrawer::Draw(const GpuImage& image, const ImageLook& look) const {
  DrawFlat(image, {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}, look);
}

}  // namespace ray
