#pragma once

#include <memory>
#include <vector>

#include "source/draw/gl/Gpu.h"
#include "source/draw/gl/ShaderProgram.h"
#include "source/draw/gl/SurfaceShader.h"
#include "source/draw/preview/PreviewView.h"

namespace ray {

/// Draws previews of scenes.
class SurfaceDrawer {
 public:
  /// Uploads a preview, which stays on the GPU while the pointer exists. Throws ContextError if its memory is full.
  std::shared_ptr<GpuSurfaces> Upload(const PreviewScene& preview) const;
  /// Draws the environment over the whole viewport, if the scene has one. Call it first.
  void DrawSky(const GpuSurfaces& surfaces, const PreviewView& view) const;
  /// Draws opaque surfaces, then clear ones without writing depth. Throws ContextError if the driver rejects a shader
  /// or its memory is full.
  ///   shadows   true if the strongest lights cast shadows
  void Draw(GpuSurfaces& surfaces, const ClipMatrix& clip_from_drawing, const PreviewView& view, bool shadows) const;
  /// Draws the edges of triangles in one color; those of triangles that are small on the screen are fainter.
  void DrawEdges(const GpuSurfaces& surfaces, const ClipMatrix& clip_from_drawing, const Rgba& color) const;

 private:
  /// Fills the shadow maps, once.
  void DrawShadows(GpuSurfaces& surfaces) const;
  const ShaderProgram& ProgramFor(const SurfaceFeatures& features) const;
  void UseView(const ShaderProgram& program, const GpuSurfaces& surfaces, const PreviewView& view) const;
  void UseLights(const ShaderProgram& program, const GpuSurfaces& surfaces, const PreviewView& view,
                 bool shadows) const;
  void UseMaterial(const ShaderProgram& program, const GpuSurfaces& surfaces, const SurfaceMaterial& material) const;

  VertexArray nothing_;
  // Created when a scene first needs them, since compiling all would take longer than drawing.
  struct Made {
    SurfaceFeatures features;
    std::unique_ptr<ShaderProgram> program;
  };
  mutable std::vector<Made> programs_;
  mutable std::unique_ptr<ShaderProgram> sky_, edges_, depth_;
};

}  // namespace ray
