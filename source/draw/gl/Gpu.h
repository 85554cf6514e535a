#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "source/draw/gl/Objects.h"
#include "source/draw/preview/PreviewScene.h"

/// The representation of lists and images on the GPU.
namespace ray {

struct GpuSurfaces {
  Buffer vertices, uvs, colors, indices, lights;
  VertexArray shaded;  // with normals and texture coordinates
  VertexArray plain;   // with positions alone
  std::vector<SurfaceBatch> batches;
  std::unordered_map<const Texture*, Texture2D> textures;
  std::optional<Texture2D> environment;
  bool has_colors = false;  // of vertices
  R2::Color background, around;
  PreviewLights preview_lights;
  std::vector<ClipMatrix> shadow_views;  // of the first lights
  // an array of depths, one layer per view; created on demand
  std::optional<Texture2D> shadow_maps;
};

struct GpuLines {
  Buffer vertices;
  VertexArray colored;
  GLsizei count = 0;  // number of vertices
};

struct GpuImage {
  Texture2D texture;
  int width = 0, height = 0;
};

}  // namespace ray
