#pragma once

#include <memory>
#include <vector>

#include "source/draw/FrameState.h"
#include "source/draw/gl/Gpu.h"
#include "source/draw/gl/ShaderProgram.h"
#include "source/draw/gl/SurfaceShader.h"

namespace ray {

inline constexpr int no_probe = -1;

/// What all materials of a drawing have in common.
struct SurfacePass {
  const GpuSurfaces& surfaces;
  const GpuTriangles& triangles;  // all of the former, or fewer
  SurfaceFeatures features;
  const ClipMatrix& clip_from_drawing;
  const PreviewView& view;
  GLint most_lights;
  bool is_encoded = false;  // by the framebuffer, so that the shader does not
  int probe = no_probe;     // which sees this, but for what shows that probe
};

/// Scenes, shaded pixel by pixel.
class SurfaceDrawer {
 public:
  SurfaceDrawer();
  /// On the GPU until the pointer goes. Throws ContextError when its memory is full, or the driver rejects a shader.
  std::shared_ptr<GpuSurfaces> Upload(const ScenePicture& picture) const;
  /// What sparse drawings show instead of all surfaces; null for these.
  void SetFewer(GpuSurfaces& surfaces, const std::shared_ptr<const Surfaces>& fewer) const;
  /// Draws the shadow maps, once: from now on lights cast shadows where `is_on`. Throws ContextError when memory is
  /// full.
  void SetShadows(GpuSurfaces& surfaces, bool is_on) const;
  /// Draws what mirrors show, once for each state of the shadows.
  void DrawProbes(GpuSurfaces& surfaces) const;
  /// The environment over all of the viewport, to be drawn first; nothing for a scene without one.
  void DrawSky(const GpuSurfaces& surfaces, const PreviewView& view, bool for_probe = false) const;
  /// Opaque surfaces first, then clear ones without writing depth.
  void Draw(const GpuSurfaces& surfaces, const ClipMatrix& clip_from_drawing, const PreviewView& view,
            const DrawingDetail& detail = {}) const;
  /// Edges of triangles in one color, those of triangles that are small on the screen the fainter.
  void DrawEdges(const GpuSurfaces& surfaces, const ClipMatrix& clip_from_drawing, const Rgba& color) const;

 private:
  /// One side of the scene as a probe sees it; but for what shows that probe.
  void DrawSide(const GpuSurfaces& surfaces, const SurfaceFeatures& features, std::size_t probe, int side) const;
  /// Depths of the opaque surfaces alone.
  void DrawDepths(const SurfacePass& pass) const;
  const ShaderProgram& UseDepth() const;
  /// All batches of a pass, in the bound framebuffer.
  void DrawBatches(const SurfacePass& pass) const;
  /// The program of a pass for surfaces that mirror or bend light, or for those that do not, ready but for a material.
  const ShaderProgram& UseFor(const SurfacePass& pass, bool mirrors) const;
  void UseMode(const ShaderProgram& program, const GpuSurfaces& surfaces, const PreviewView& view) const;
  const ShaderProgram& ProgramFor(const SurfaceFeatures& features) const;
  void Use(const ShaderProgram& program, const GpuSurfaces& surfaces, const PreviewView& view,
           bool for_probe = false) const;
  void UseLights(const ShaderProgram& program, const GpuSurfaces& surfaces, const SurfaceFeatures& features,
                 const PreviewView& view, GLint most_lights) const;
  void UseMaterial(const ShaderProgram& program, const GpuSurfaces& surfaces, const SurfaceMaterial& material) const;
  void UseProbe(const ShaderProgram& program, const GpuSurfaces& surfaces, const SurfaceBatch& batch) const;

  VertexArray nothing_;
  Sampler largest_level_;  // of a cube map
  // Made when a scene first asks for them, for to compile them all would take longer than to draw.
  struct Made {
    SurfaceFeatures features;
    std::unique_ptr<ShaderProgram> program;
  };
  mutable std::vector<Made> programs_;
  mutable std::unique_ptr<ShaderProgram> sky_, edges_, depth_;
};

}  // namespace ray
