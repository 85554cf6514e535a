#pragma once

#include <vector>

#include "R3/Mesh.h"
#include "tests/Draw.h"

/// D3: places and sizes at which meshes are hard to hit: far, tiny, huge, squeezed and slanted.
inline std::vector<R3::Matrix> HardPlacements(Draw& draw) {
  const auto scaled = [](double x, double y, double z, double shift) {
    R3::Matrix m;
    m.m = {{{x, 0, 0, shift}, {0, y, 0, -shift}, {0, 0, z, shift}}};
    return m;
  };
  std::vector<R3::Matrix> matrices{scaled(1, 1, 1, 1e5),     scaled(1e-3, 1e-3, 1e-3, 0), scaled(1e-3, 1e-3, 1e-3, 1e5),
                                   scaled(1e6, 1e6, 1e6, 0), scaled(1, 1e-4, 1, 0),       scaled(1e-4, 1, 1, 1e5)};
  for (int i = 0; i < 6; ++i) matrices.push_back(draw.Affine(4));
  return matrices;
}

inline R3::MeshData Moved(R3::MeshData data, const R3::Matrix& matrix) {
  for (R3::Point& p : data.positions) p = matrix * p;
  return data;
}
