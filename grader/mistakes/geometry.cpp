#include "grader/mistakes/Tables.h"

#include "R3/Transform.h"
#include "grader/Changes.h"

namespace ray::grade {

extern const MistakeTable geometry_mistakes{
    {.name = "normal_by_matrix",
     .title = "normals are transformed like points",
     .expected = "Normals go by the inverse transpose of the matrix that moves points.",
     .hint = "Look at a sphere that is scaled along one axis.",
     .make = [](Variant& v) { v.rules.normal = ShadingRules::Normal::by_matrix; }},
    {.name = "normal_by_inverse",
     .title = "normals are transformed by the inverse matrix, not transposed",
     .expected = "Normals go by the inverse transpose of the matrix that moves points.",
     .hint = "Does the light on a rotated box turn the wrong way?",
     .make = [](Variant& v) { v.rules.normal = ShadingRules::Normal::by_inverse; }},
    {.name = "normal_untransformed",
     .title = "normals are not transformed",
     .expected = "A normal found in the object's own frame has to be brought into the world.",
     .hint = "Look at the shading of something that is rotated.",
     .make = [](Variant& v) { v.rules.normal = ShadingRules::Normal::untransformed; }},
    {.name = "normal_inward",
     .title = "normals point inward",
     .expected = "N points outward, or to the side that the ray came from.",
     .hint = "Which sign has N.L on the lit side?",
     .make = [](Variant& v) { v.rules.normal = ShadingRules::Normal::inward; }},
    {.name = "normal_not_facing",
     .title = "normals are not turned to the viewer",
     .expected = "A surface seen from behind is shaded with the normal on the viewer's side.",
     .hint = "Look at the inside of something open, or at a wall from behind.",
     .make = [](Variant& v) { v.rules.normal = ShadingRules::Normal::not_facing; }},
    {.name = "normal_not_normalized",
     .title = "normals are not of unit length",
     .expected = "N has length 1 before any dot product is taken.",
     .hint = "Do spheres of another radius, or scaled ones, have another brightness?",
     .make = [](Variant& v) { v.rules.normal = ShadingRules::Normal::not_normalized; }},
    {.name = "normal_stretched",
     .title = "normals are not normalized after they are transformed",
     .expected = "N has length 1 before any dot product is taken.",
     .hint = "Do scaled shapes have another brightness?",
     .make = [](Variant& v) { v.rules.normal = ShadingRules::Normal::stretched; }},
    {.name = "flat_shading",
     .title = "meshes are shaded flat",
     .expected = "Normals at the corners are blended by the barycentric coordinates of the hit.",
     .hint = "Can you see the triangles?",
     .make = [](Variant& v) { v.rules.normal = ShadingRules::Normal::flat; }},
    {.name = "transforms_reversed",
     .title = "nested transforms are multiplied in the wrong order",
     .expected = "A point goes through its own matrix first, then through its parent's: M = M_parent M_child.",
     .hint = "Which of two nested groups acts first?",
     .make = [](Variant& v) { ReverseTransforms(v.OwnScene()); }},
    {.name = "transforms_ignored",
     .title = "transforms are ignored",
     .expected = "Every shape is placed by the matrices of the groups around it.",
     .hint = "Is everything where its own line puts it?",
     .make = [](Variant& v) { ChangeTransforms(v.OwnScene(), [](const R3::Matrix&) { return R3::Matrix{}; }); }},
    {.name = "matrix_transposed",
     .title = "rotations are transposed",
     .expected = "Matrices are in row-major order, for column vectors: the translation is the last column.",
     .hint = "Do things turn the other way round?",
     .make =
         [](Variant& v) {
           ChangeTransforms(v.OwnScene(), [](const R3::Matrix& matrix) {
             R3::Matrix transposed = matrix;
             for (std::size_t i = 0; i < 3; ++i)
               for (std::size_t j = 0; j < 3; ++j) transposed.m[i][j] = matrix.m[j][i];
             return transposed;
           });
         }},
    {.name = "matrix_by_columns",
     .title = "matrices are read by columns",
     .expected = "Matrices are in row-major order, for column vectors: the translation is the last column.",
     .hint = "Is everything at the origin of its group?",
     .make =
         [](Variant& v) {
           ChangeTransforms(v.OwnScene(), [](const R3::Matrix& matrix) {
             R3::Matrix transposed;
             for (std::size_t i = 0; i < 3; ++i)
               for (std::size_t j = 0; j < 3; ++j) transposed.m[i][j] = matrix.m[j][i];
             return transposed;
           });
         }},
    {.name = "spheres_missing",
     .title = "spheres are missing",
     .expected = "The camera ray meets a sphere where |o + t d - c| = r; the nearest t in front of the eye counts.",
     .hint = "Does the quadratic equation find a root for a ray through the middle?",
     .make =
         [](Variant& v) {
           RemoveShapes(v.OwnScene(), [](const R3::Shape& shape) { return shape.AsSphere().has_value(); });
         }},
    {.name = "triangles_missing",
     .title = "triangles and polygons are missing",
     .expected = "A hit of the plane is a hit of the triangle if it is inside all three edges.",
     .hint = "Does your test depend on the order of the corners?",
     .make =
         [](Variant& v) {
           RemoveShapes(v.OwnScene(), [](const R3::Shape& shape) { return !shape.IsSolid() && shape.IsBounded(); });
         }},
    {.name = "scale_ignored",
     .title = "scaling is ignored",
     .expected = "Every shape is placed and sized by the matrices of the groups around it.",
     .hint = "Is each column of your matrices of unit length?",
     .make =
         [](Variant& v) {
           ChangeTransforms(v.OwnScene(), [](const R3::Matrix& matrix) {
             R3::Matrix unscaled = matrix;
             for (std::size_t j = 0; j < 3; ++j) {
               const double length = Length(R3::Vector{matrix.m[0][j], matrix.m[1][j], matrix.m[2][j]});
               for (std::size_t i = 0; i < 3 && length > 0; ++i) unscaled.m[i][j] /= length;
             }
             return unscaled;
           });
         }},
    {.name = "nested_transforms_ignored",
     .title = "transforms within transforms are ignored",
     .expected = "A point goes through its own matrix first, then through its parent's: M = M_parent M_child.",
     .hint = "What happens to a group within a group?",
     .make = [](Variant& v) { IgnoreNestedTransforms(v.OwnScene()); }},
    {.name = "innermost_transform_only",
     .title = "a group's transform replaces those around it",
     .expected = "A point goes through its own matrix first, then through its parent's: M = M_parent M_child.",
     .hint = "What happens to a group within a group?",
     .make = [](Variant& v) { KeepInnermostTransforms(v.OwnScene()); }},
    {.name = "group_material_ignored",
     .title = "shapes do not inherit the material of their group",
     .expected = "A shape without a material of its own has that of the innermost group that has one.",
     .hint = "Which material has a shape whose number is -1?",
     .make = [](Variant& v) { ChangeInheritedMaterials(v.OwnScene(), [](int) { return 0; }); }},
    {.name = "last_material_inherited",
     .title = "shapes inherit the material that was used last",
     .expected = "A shape without a material of its own has that of the innermost group that has one.",
     .hint = "Which material has a shape whose number is -1, after a sibling with a number?",
     .make = [](Variant& v) { ChangeInheritedMaterials(v.OwnScene(), [](int last) { return last; }); }},
    {.name = "materials_from_one",
     .title = "materials are counted from one",
     .expected = "Materials are numbered from 0 in the order of the file.",
     .hint = "Which number has the first material?",
     .make = [](Variant& v) { CountMaterialsFromOne(v.OwnScene()); }},
    {.name = "triangles_culled",
     .title = "triangles are not seen from behind",
     .expected = "A triangle is hit from both sides.",
     .hint = "Does your test return early where the ray meets the back?",
     .make = [](Variant& v) { RemoveBacks(v.OwnScene(), [](const R3::Shape& shape) { return !shape.IsSolid(); }); }},
    {.name = "boxes_hollow",
     .title = "rays inside of boxes do not hit them",
     .expected = "Where the nearer root is behind the ray's start, the farther one counts.",
     .hint = "What does your box test return for a ray that starts inside?",
     .make =
         [](Variant& v) {
           RemoveBacks(v.OwnScene(),
                       [](const R3::Shape& shape) { return shape.IsSolid() && !shape.AsSphere().has_value(); });
         }},
    {.name = "spheres_hollow",
     .title = "rays inside of spheres do not hit them",
     .expected = "Where the nearer root is behind the ray's start, the farther one counts.",
     .hint = "What does your sphere test return for a ray that starts inside?",
     .make =
         [](Variant& v) {
           RemoveBacks(v.OwnScene(), [](const R3::Shape& shape) { return shape.AsSphere().has_value(); });
         }},
    {.name = "hits_behind_eye",
     .title = "surfaces behind the eye are seen",
     .expected = "Only hits at t > 0 count, in front of the eye.",
     .hint = "Is a negative t rejected before it is compared?",
     .make = [](Variant& v) { v.rules.behind_the_eye = true; }},
    {.name = "matrix_inverted",
     .title = "matrices are used in place of their inverses",
     .expected = "Shapes are placed by M; rays go into a shape's frame by the inverse of M.",
     .hint = "Do things move the opposite way?",
     .make =
         [](Variant& v) {
           ChangeTransforms(v.OwnScene(), [](const R3::Matrix& matrix) {
             const auto transform = R3::Transform::Of(matrix);
             return transform ? transform->Inverse() : matrix;
           });
         }},
    {.name = "last_shape_wins",
     .title = "the last shape in the file hides the others",
     .expected = "The hit with the smallest t in front of the eye counts, whatever the order of shapes.",
     .hint = "Is a hit compared with the nearest so far?",
     .make = [](Variant& v) { v.depth.choice = DepthRules::Choice::last_in_file; }},
    {.name = "first_shape_wins",
     .title = "the first shape in the file hides the others",
     .expected = "The hit with the smallest t in front of the eye counts, whatever the order of shapes.",
     .hint = "Does your loop over the shapes end at the first hit?",
     .make = [](Variant& v) { v.depth.choice = DepthRules::Choice::first_in_file; }},
    {.name = "t_of_each_group",
     .title = "distances in groups of different scale are compared",
     .expected = "t is compared along one ray: a direction that is normalized in a scaled group counts in its units.",
     .hint = "Is the direction normalized after it is transformed?",
     .make = [](Variant& v) { v.depth.choice = DepthRules::Choice::by_local_length; }},
    {.name = "far_root",
     .title = "spheres show their far side",
     .expected = "The smaller root in front of the eye counts.",
     .hint = "Which of the two roots does your program take?",
     .make = [](Variant& v) { v.depth.far_side_of_spheres = true; }},
};

}  // namespace ray::grade
