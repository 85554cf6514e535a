#include "source/draw/gl/Canvas.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <string>
#include <vector>

#include "R2/ImageFile.h"
#include "source/draw/contexts/Context.h"

namespace ray {

void UseAlpha() { glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA); }

Canvas::Canvas(Target target) {
  if (target == Target::own) own_.emplace();
}

void Canvas::Begin(int width, int height, const R2::Color& background) {
  assert(width >= 0 && height >= 0);
  width_ = width, height_ = height;
  glBindFramebuffer(GL_FRAMEBUFFER, own_ ? own_->framebuffer.Name() : 0);
  if (own_ && (own_->width != width || own_->height != height)) Resize(*own_, width, height);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glEnable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glEnable(GL_BLEND);
  UseAlpha();
  SetViewport(0, 0, width, height);
  Fill(background);
}

void Canvas::Fill(const R2::Color& color) const {
  const auto channel = [](double c) { return static_cast<float>(R2::ToByte(c)) / 255.0F; };
  glClearColor(channel(color.r), channel(color.g), channel(color.b), 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Canvas::Resize(OffscreenTarget& own, int width, int height) const {
  GLint most = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (width > most || height > most)
    throw ContextError("cannot draw " + size + "; the GPU allows " + std::to_string(most) + " per side");
  // A window can shrink to nothing, a framebuffer cannot.
  const GLsizei columns = std::max(width, 1), rows = std::max(height, 1);
  glBindRenderbuffer(GL_RENDERBUFFER, own.color.Name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_SRGB8_ALPHA8, columns, rows);  // as bytes until sRGB is enabled
  glBindRenderbuffer(GL_RENDERBUFFER, own.depth.Name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, columns, rows);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, own.color.Name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, own.depth.Name());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw ContextError("cannot draw " + size + "; the driver rejects the framebuffer");
  own.width = width, own.height = height;
}

void Canvas::Apply(const Viewport& viewport) const {
  glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
  glScissor(viewport.x, viewport.y, viewport.width, viewport.height);
}

void Canvas::SetViewport(int x, int y, int width, int height) {
  viewport_ = {x, y, width, height};
  Apply(viewport_);
}

R2::Image Canvas::Read() const {
  assert(width_ >= 1 && height_ >= 1);
  std::vector<std::uint8_t> rgba(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  assert(glGetError() == GL_NO_ERROR);
  R2::Image image(width_, height_);
  const std::uint8_t* pixel = rgba.data();
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x, pixel += 4)
      image.Set(x, y, R2::Color{pixel[0] / 255.0, pixel[1] / 255.0, pixel[2] / 255.0});
  return image;
}

KeptTarget::KeptTarget() {
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
  glGetIntegerv(GL_VIEWPORT, viewport_.data());
  glGetIntegerv(GL_SCISSOR_BOX, clip_.data());
}

KeptTarget::~KeptTarget() {
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(framebuffer_));
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  glScissor(clip_[0], clip_[1], clip_[2], clip_[3]);
  glEnable(GL_SCISSOR_TEST);
}

bool CanEncodeSrgb() {
  GLint framebuffer = 0, encoding = GL_LINEAR;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, framebuffer == 0 ? GL_BACK_LEFT : GL_COLOR_ATTACHMENT0,
                                        GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING, &encoding);
  return encoding == GL_SRGB;
}

}  // namespace ray
