#pragma once

#include "source/view/gl/Objects.h"

/// What lists and pictures become on the GPU.
namespace ray {

struct GpuTriangles {
  Buffer vertices, indices;
  VertexArray colored;            // with each vertex's color
  VertexArray plain;              // with positions alone
  GLsizei opaque = 0, clear = 0;  // indices, the opaque ones first
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
