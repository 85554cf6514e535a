#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "R2/Color.h"
#include "source/draw/preview/PreviewLights.h"
#include "source/scene/Environment.h"
#include "source/scene/Texture.h"

namespace ray {

/// A corner of triangles, in a DrawingSpace.
struct SurfaceVertex {
  std::array<float, 3> at{};
  std::array<std::int16_t, 4> normal{};  // unit, outward, in units of 1/32767; the last is for alignment
};

/// A material in the terms of the preview's shader.
struct SurfaceMaterial {
  R2::Color emission, ambient;  // ambient: ka times the scene's ambient light
  R2::Color kd, ks, kr, kt;
  double n = 1;                            // exponent of the highlight
  std::shared_ptr<const Texture> texture;  // null for none
  R2::Vector texture_scale{1, 1};
  bool texture_multiplies_ambient = false;  // and vertex colors do so, too
  bool one_sided = false;                   // backs are not drawn
};

/// The triangles of one material: `count` indices from `first` on.
struct SurfaceBatch {
  SurfaceMaterial material;
  std::uint32_t first = 0, count = 0;
  bool is_clear = false;  // the background is visible through it
};

/// Triangles in batches, the opaque ones first. Fronts face outward.
struct Surfaces {
  std::vector<SurfaceVertex> vertices;
  std::vector<std::array<float, 2>> uvs;     // one per vertex, or none if no material has a texture
  std::vector<std::array<float, 3>> colors;  // one per vertex, or none if no material has them
  std::vector<std::uint32_t> indices;        // three per triangle
  std::vector<SurfaceBatch> batches;
};

/// The limits of a preview that a software renderer draws in about 20 ms. Above them, shapes become coarser and then
/// boxes, meshes are simplified, and boxes are omitted evenly.
struct PreviewBudget {
  std::int64_t shape_triangles = 100'000;  // of all shapes that are not meshes
  std::int64_t mesh_triangles = 150'000;   // of all meshes
  std::int64_t boxes = 20'000;
};

/// The radius around the scene's center, in radii of the scene, within which infinite shapes count as part of the
/// drawing. They are drawn beyond that, up to where a screen shows no step to the horizon.
inline constexpr double times_the_scene = 10;

/// A scene as triangles with lights, and the number of missing parts.
struct PreviewScene {
  Surfaces surfaces;
  PreviewLights lights;
  R2::Color around;                                // mean radiance of the environment, or in mode path the background
  R2::Color background;                            // visible without an environment
  std::shared_ptr<const Environment> environment;  // null for none
  std::int64_t simplified = 0;                     // number of meshes with fewer triangles than in the scene
  std::int64_t as_boxes = 0;                       // number of primitives drawn as their bounding boxes
  std::int64_t left_out = 0;                       // number of primitives not drawn
};

/// Creates the preview of a scene: materials with their textures, Phong's highlights, mirrors that reflect only the
/// surroundings, and clear surfaces that transmit light straight. Moving objects are where they are when the shutter
/// opens.
PreviewScene PreviewOf(const World& world, const RenderSettings& settings, const DrawingSpace& space,
                       const PreviewBudget& budget = {});

/// Returns an image of at most that many columns and rows, in which each pixel is the mean of a block of the original.
R2::Image Shrunk(const R2::Image& image, int width, int height);

}  // namespace ray
