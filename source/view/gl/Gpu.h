#pragma once

#include "source/view/gl/Objects.h"

/// What lists and pictures are kept as. Each holds on to the functions it is deleted with.
namespace ray {

class GpuTriangles {
 public:
  explicit GpuTriangles(const std::shared_ptr<const Functions>& gl)
      : vertices(gl), indices(gl), colored(gl), plain(gl) {}

  Buffer vertices, indices;
  VertexArray colored;            // with each vertex's colour
  VertexArray plain;              // with places alone
  GLsizei opaque = 0, clear = 0;  // indices, the opaque ones first
};

class GpuLines {
 public:
  explicit GpuLines(const std::shared_ptr<const Functions>& gl) : vertices(gl), colored(gl) {}

  Buffer vertices;
  VertexArray colored;
  GLsizei count = 0;  // vertices
};

class GpuPicture {
 public:
  explicit GpuPicture(const std::shared_ptr<const Functions>& gl) : texture(gl) {}

  Texture2D texture;
  int width = 0, height = 0;
};

}  // namespace ray
