#pragma once

#include <functional>
#include <string>
#include <vector>

#include "R2/Image.h"
#include "R3/Matrix.h"
#include "R3/Recipe.h"
#include "source/scene/Scene.h"

/// Small changes that mistakes are made of.
namespace ray::grade {

/// A scene of its own with the same shapes and textures, which are shared.
Scene Copied(const Scene& scene);

/// Applies `change` to each material.
void ChangeMaterials(Scene& scene, const std::function<void(Material&)>& change);

/// Makes each light again from its recipe after `change`; `at` finds an argument by its name, null where there is none.
struct LightArguments {
  std::string kind;
  R3::Recipe& recipe;
  double* At(const std::string& name);
};
void ChangeLights(Scene& scene, const std::function<void(LightArguments&)>& change);

/// Applies `change` to the matrix of every group, and finds their bounds anew.
void ChangeTransforms(Scene& scene, const std::function<R3::Matrix(const R3::Matrix&)>& change);
/// Leaves out the transforms of groups within groups that have one.
void IgnoreNestedTransforms(Scene& scene);
/// Turns the texture coordinates of spheres so that their poles lie along y, and leaves the spheres where they are.
void PutPolesAlongY(Scene& scene);
/// Replaces the image of each texture by `change` of it.
void ChangeTextures(Scene& scene, const std::function<R2::Image(const R2::Image&)>& change);
/// Nested transforms are multiplied in the wrong order: those of a child before those of its parent.
void ReverseTransforms(Scene& scene);
/// Takes the shapes away that `is_lost` holds for.
void RemoveShapes(Scene& scene, const std::function<bool(const R3::Shape&)>& is_lost);

/// Applies `change` to each color.
R2::Image EachColor(const R2::Image& image, const std::function<R2::Color(const R2::Color&)>& change);
R2::Image EachChannel(const R2::Image& image, double (*change)(double));
/// An image of width x height whose pixels come from elsewhere: `from` gives the place in the old one, which is clamped
/// to its edge.
struct PixelPlace {
  int x, y;
};
R2::Image Moved(const R2::Image& image, int width, int height, const std::function<PixelPlace(int x, int y)>& from);

}  // namespace ray::grade
