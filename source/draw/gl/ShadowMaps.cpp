#include "source/draw/gl/ShadowMaps.h"

#include "source/draw/gl/Canvas.h"
#include "source/draw/gl/Objects.h"

namespace ray {

namespace {

constexpr GLsizei side = 1024;  // texels; a scene seen from outside is then resolved to 1/500 of its radius

}  // namespace

GpuShadows FilledShadows(int count, const std::function<void(int map)>& draw) {
  GpuShadows shadows;
  glBindTexture(GL_TEXTURE_2D_ARRAY, shadows.maps.Name());
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT24, side, side, count, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
               nullptr);
  ReadFirstLevel(GL_TEXTURE_2D_ARRAY, GL_LINEAR);  // between the answers of four texels
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  CheckMemory();

  const KeptTarget kept;
  const Framebuffer framebuffer;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.Name());
  glDrawBuffer(GL_NONE);
  glViewport(0, 0, side, side);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(2, 2);  // so that a surface does not shade itself where a texel is seen aslant
  for (int map = 0; map < count; ++map) {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, shadows.maps.Name(), 0, map);
    glClear(GL_DEPTH_BUFFER_BIT);
    draw(map);
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
  return shadows;
}

}  // namespace ray
