#pragma once

#include <functional>
#include <string>

#include "R2/Image.h"
#include "R3/Matrix.h"
#include "R3/Shape.h"
#include "source/scene/Scene.h"

/// Small changes from which mistakes are composed.
namespace ray::grade {

/// Returns a separate scene that shares the shapes and textures.
Scene Copied(const Scene& scene);

/// Applies `change` to each material.
void ChangeMaterials(Scene& scene, const std::function<void(Material&)>& change);

/// Creates each light again from its recipe after `change`; `at` returns an argument by its name, null if there is
/// none.
struct LightArguments {
  std::string kind;
  R3::Recipe& recipe;
  double* At(const std::string& name);
};
void ChangeLights(Scene& scene, const std::function<void(LightArguments&)>& change);

/// Applies `change` to the matrix of every group, and computes their bounds again.
void ChangeTransforms(Scene& scene, const std::function<R3::Matrix(const R3::Matrix&)>& change);
/// Removes the transforms of groups within groups that have one.
void IgnoreNestedTransforms(Scene& scene);
/// Rotates the texture coordinates of spheres so that their poles are along y, without moving the spheres.
void PutPolesAlongY(Scene& scene);
/// Applies `change` to the image of each texture.
void ChangeTextures(Scene& scene, const std::function<R2::Image(const R2::Image&)>& change);
/// Removes the transforms of groups around groups that have one.
void KeepInnermostTransforms(Scene& scene);
/// Gives each shape that inherits a group's material another one: `material` returns its number from the last number
/// in the file before the shape, that of a group included.
void ChangeInheritedMaterials(Scene& scene, const std::function<int(int last)>& material);
/// Moves every material's number by one: the first becomes the default material.
void CountMaterialsFromOne(Scene& scene);
/// Removes the backs of the shapes for which `is_lost` returns true.
void RemoveBacks(Scene& scene, const std::function<bool(const R3::Shape&)>& is_lost);
/// Multiplies nested transforms in the wrong order: those of a child before those of its parent.
void ReverseTransforms(Scene& scene);
/// Removes the shapes for which `is_lost` returns true.
void RemoveShapes(Scene& scene, const std::function<bool(const R3::Shape&)>& is_lost);

/// Applies `change` to each color.
R2::Image EachColor(const R2::Image& image, const std::function<R2::Color(const R2::Color&)>& change);
R2::Image EachChannel(const R2::Image& image, double (*change)(double));
/// Returns an image of width x height whose pixels come from elsewhere: `from` returns the place in the old image,
/// which is clamped to its edge.
struct PixelPlace {
  int x, y;
};
R2::Image Moved(const R2::Image& image, int width, int height, const std::function<PixelPlace(int x, int y)>& from);

}  // namespace ray::grade
