#include "source/draw/gl/CoarseDrawer.h"

#include <algorithm>
#include <string>

#include "source/draw/contexts/Context.h"
#include "source/draw/gl/Canvas.h"

namespace ray {
namespace {

// A triangle over the whole viewport.
constexpr const char* vertex_shader = R"(#version 330 core
out vec2 place;
void main() {
  place = vec2(gl_VertexID == 1 ? 2 : 0, gl_VertexID == 2 ? 2 : 0);
  gl_Position = vec4(2.0 * place - 1.0, 0, 1);
}
)";

constexpr const char* fragment_shader = R"(#version 330 core
in vec2 place;
uniform sampler2D colors, depths;
out vec4 color;
void main() {
  color = vec4(texture(colors, place).rgb, 1);
  gl_FragDepth = texture(depths, place).r;
}
)";

constexpr GLint colors_unit = 0, depths_unit = 1;

void Describe(const Texture2D& texture, GLint format, GLenum channels, GLenum type, int width, int height,
              GLint filter) {
  glBindTexture(GL_TEXTURE_2D, texture.Name());
  glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, channels, type, nullptr);
  ReadFirstLevel(GL_TEXTURE_2D, filter);
}

}  // namespace

void CoarseDrawer::Fit(int width, int height, bool is_srgb) const {
  if (small_ && small_->width == width && small_->height == height && small_->is_srgb == is_srgb) return;
  if (!small_) small_ = std::make_unique<Small>();
  small_->width = width, small_->height = height, small_->is_srgb = is_srgb;
  glActiveTexture(GL_TEXTURE0 + colors_unit);
  Describe(small_->colors, is_srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width, height, GL_LINEAR);
  Describe(small_->depths, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, width, height, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, small_->framebuffer.Name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, small_->colors.Name(), 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, small_->depths.Name(), 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw ContextError("cannot draw " + std::to_string(width) + " x " + std::to_string(height) +
                       " pixels off screen; the driver rejects the framebuffer");
}

bool CoarseDrawer::FitSamples(int width, int height, bool is_srgb) const {
  if (samples_ && samples_->width == width && samples_->height == height && samples_->is_srgb == is_srgb)
    return samples_->is_complete;
  if (!samples_) samples_ = std::make_unique<Samples>();
  samples_->width = width, samples_->height = height, samples_->is_srgb = is_srgb;
  GLint most = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  const GLsizei count = std::min(most, samples_of_smooth);
  const auto describe = [&](const Renderbuffer& buffer, GLenum format) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffer.Name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, count, format, width, height);
  };
  describe(samples_->colors, is_srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8);
  describe(samples_->depths, GL_DEPTH_COMPONENT24);
  glBindFramebuffer(GL_FRAMEBUFFER, samples_->framebuffer.Name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samples_->colors.Name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, samples_->depths.Name());
  samples_->is_complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  return samples_->is_complete;
}

void CoarseDrawer::DrawSmoothly(const std::function<void()>& draw) const {
  if (DrawSamples(draw))
    Enlarge();
  else
    draw();
}

bool CoarseDrawer::DrawSamples(const std::function<void()>& draw) const {
  const KeptTarget kept;
  const int width = kept.Viewport()[2], height = kept.Viewport()[3];
  if (width == 0 || height == 0) return false;
  const bool is_srgb = CanEncodeSrgb();
  Fit(width, height, is_srgb);
  if (!FitSamples(width, height, is_srgb)) return false;
  glBindFramebuffer(GL_FRAMEBUFFER, samples_->framebuffer.Name());
  glViewport(0, 0, width, height);
  glScissor(0, 0, width, height);
  draw();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, samples_->framebuffer.Name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, small_->framebuffer.Name());
  // The means are of displayed values, as those of an image's bytes would be.
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  return true;
}

void CoarseDrawer::Enlarge() const {
  if (!enlargement_) {
    enlargement_ = std::make_unique<ShaderProgram>("the enlarged preview", vertex_shader, fragment_shader);
    enlargement_->Use();
    glUniform1i((*enlargement_)["colors"], colors_unit);
    glUniform1i((*enlargement_)["depths"], depths_unit);
  }
  enlargement_->Use();
  glActiveTexture(GL_TEXTURE0 + depths_unit);
  glBindTexture(GL_TEXTURE_2D, small_->depths.Name());
  glActiveTexture(GL_TEXTURE0 + colors_unit);
  glBindTexture(GL_TEXTURE_2D, small_->colors.Name());
  glBindVertexArray(nothing_.Name());
  if (small_->is_srgb) glEnable(GL_FRAMEBUFFER_SRGB);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  if (small_->is_srgb) glDisable(GL_FRAMEBUFFER_SRGB);
}

void CoarseDrawer::Draw(int step, const std::function<void()>& draw) const {
  {
    const KeptTarget kept;
    const auto& viewport = kept.Viewport();
    const int width = (viewport[2] + step - 1) / step, height = (viewport[3] + step - 1) / step;
    if (width == 0 || height == 0) return;
    Fit(width, height, CanEncodeSrgb());
    glBindFramebuffer(GL_FRAMEBUFFER, small_->framebuffer.Name());
    glViewport(0, 0, width, height);
    glScissor(0, 0, width, height);
    draw();
  }
  Enlarge();
}

}  // namespace ray
