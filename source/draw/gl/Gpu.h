#pragma once

#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "source/draw/gl/Objects.h"
#include "source/draw/gl/ShadowMaps.h"
#include "source/draw/gl/SurfaceShader.h"
#include "source/draw/preview/ScenePicture.h"
#include "source/draw/preview/ShadowViews.h"

/// What lists and pictures become on the GPU.
namespace ray {

struct GpuTriangles {
  Buffer vertices, uvs, colors, indices;
  VertexArray shaded;  // with normals and texture coordinates
  VertexArray plain;   // with positions alone
  std::vector<SurfaceBatch> batches;
};

struct GpuSurfaces {
  GpuTriangles all;
  std::shared_ptr<const Surfaces> fewer_of;  // what `fewer` shows; null for none
  std::optional<GpuTriangles> fewer;
  Buffer lights;
  std::unordered_map<const Texture*, Texture2D> textures, reliefs;
  std::optional<Texture2D> environment;
  DiffuseLight diffuse_light;
  R2::Color background;
  SurfaceFeatures features;
  bool head_light = false;
  std::vector<PreviewLight> preview_lights;
  ShadowViews shadow_views;           // where there are shadows
  std::optional<GpuShadows> shadows;  // none until they are first asked for
  std::vector<MirrorProbe> probes;
  std::vector<Texture2D> probe_maps;  // of each of them, once they were drawn
  bool probes_have_shadows = false;   // as they were drawn
  int mirror_bounces = 0;
  ModeLook look;
};

struct GpuLines {
  Buffer vertices;
  VertexArray colored;
  GLsizei count = 0;  // vertices
};

struct GpuPicture {
  Texture2D texture;
  int width = 0, height = 0;
};

}  // namespace ray
