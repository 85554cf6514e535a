#pragma once

#include <memory>
#include <utility>

#include "source/view/gl/Functions.h"

namespace ray {

/// An object of OpenGL, deleted with its owner. It holds on to the functions, so it may outlive the painter; the
/// context has to be current then.
template <auto generate, auto remove>
class Object {
 public:
  explicit Object(std::shared_ptr<const Functions> gl) : gl_(std::move(gl)) { ((*gl_).*generate)(1, &name_); }
  ~Object() {
    if (name_) ((*gl_).*remove)(1, &name_);
  }
  Object(Object&& other) noexcept : gl_(std::move(other.gl_)), name_(std::exchange(other.name_, 0)) {}
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  GLuint Name() const { return name_; }

 private:
  std::shared_ptr<const Functions> gl_;
  GLuint name_ = 0;
};

using Buffer = Object<&Functions::GenBuffers, &Functions::DeleteBuffers>;
using VertexArray = Object<&Functions::GenVertexArrays, &Functions::DeleteVertexArrays>;
using Texture2D = Object<&Functions::GenTextures, &Functions::DeleteTextures>;
using Framebuffer = Object<&Functions::GenFramebuffers, &Functions::DeleteFramebuffers>;
using Renderbuffer = Object<&Functions::GenRenderbuffers, &Functions::DeleteRenderbuffers>;

}  // namespace ray
