#include "source/draw/gl/MirrorProbes.h"

#include <array>

#include "source/draw/Drawing.h"
#include "source/draw/gl/Canvas.h"
#include "source/draw/gl/Objects.h"

namespace ray {
namespace {

constexpr GLfloat endless = 6e4F;  // a distance that half precision holds

/// Where the sides look, and their right and up.
///   source   OpenGL 3.3 core profile (2010), table 3.20
struct Axes {
  R3::Vector towards, right, up;
};
constexpr std::array<Axes, 6> sides{{{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                     {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                     {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                     {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                                     {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
                                     {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}}};

void UseLinear(const Texture2D& map) {
  glBindTexture(GL_TEXTURE_CUBE_MAP, map.Name());
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  for (const GLenum name : std::array<GLenum, 3>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(GL_TEXTURE_CUBE_MAP, name, GL_CLAMP_TO_EDGE);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

}  // namespace

ProbeSide SideOf(const MirrorProbe& probe, int side) {
  constexpr double farthest = 8;  // radii of the scene; beyond, depths are clamped
  const Axes& axes = sides[static_cast<std::size_t>(side)];
  const R3::Vector eye{probe.at[0], probe.at[1], probe.at[2]};
  ProbeSide seen;
  seen.view.eye = probe.at;
  seen.view.directions = {AsFloats(axes.towards - axes.right - axes.up), AsFloats(2 * axes.right),
                          AsFloats(2 * axes.up)};
  seen.clip_from_drawing = Perspective(eye, axes.towards, axes.right, axes.up, probe.nearest, farthest);
  return seen;
}

Texture2D FilledProbe(GLsizei texels, const R2::Color& background, const std::function<void(int side)>& draw) {
  Texture2D map;
  UseLinear(map);
  for (GLenum i = 0; i < sides.size(); ++i)
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, 0, GL_RGBA16F, texels, texels, 0, GL_RGBA, GL_FLOAT, nullptr);
  CheckMemory();
  const KeptTarget kept;
  const Framebuffer framebuffer;
  const Renderbuffer depth;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.Name());
  glBindRenderbuffer(GL_RENDERBUFFER, depth.Name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, texels, texels);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.Name());
  glViewport(0, 0, texels, texels);
  glScissor(0, 0, texels, texels);
  const auto clear = AsFloats(background);
  for (int side = 0; side < static_cast<int>(sides.size()); ++side) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                           GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(side), map.Name(), 0);
    glClearColor(clear[0], clear[1], clear[2], endless);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw(side);
  }
  glBindTexture(GL_TEXTURE_CUBE_MAP, map.Name());
  glGenerateMipmap(GL_TEXTURE_CUBE_MAP);
  return map;
}

}  // namespace ray
