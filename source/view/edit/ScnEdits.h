#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "R3/Vector.h"
#include "source/scene/Camera.h"
#include "source/view/edit/EditHistory.h"
#include "source/view/edit/ScnField.h"

/// Edits of .scn files. They touch the words they change and nothing else: comments, blanks and ends of lines stay as
/// they are, to the byte. Numbers are written as short as they read back.
namespace ray {

/// The reason why something cannot be edited, for the user.
struct EditRefusal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Sets the values of a field, as many as it has; unchanged numbers keep their spelling. Throws EditRefusal.
TextEdits WithValues(const ScnPlaces& places, std::uint32_t statement, const ScnField& field,
                     const std::vector<double>& values);

/// Moves a shape, light, line or group by `way`, in the coordinates of the statement. Everything else, such as a mesh,
/// gets a group around it that moves it. Sums are rounded to 12 digits. Throws EditRefusal.
TextEdits Moved(const ScnPlaces& places, std::uint32_t statement, const R3::Vector& way);

/// Removes a shape, light or mesh, or a group with its contents: whole lines, with the comment at their end, where
/// nothing else is on them. Throws EditRefusal for a statement that others refer to, such as a material.
TextEdits Removed(const ScnPlaces& places, std::uint32_t statement);

/// A copy behind the statement, or behind the group that it opens, moved by `way`; and the offset of the copy.
struct Copied {
  TextEdits edits;
  std::size_t begin = 0;
};
Copied Duplicated(const ScnPlaces& places, std::uint32_t statement, const R3::Vector& way);

/// Sets the position and direction of the scene's camera, bit for bit; a scene without a camera gets one. A look_at
/// camera remains one if it can express them. Projection and shift are not edited. Throws EditRefusal.
TextEdits WithCamera(const ScnPlaces& places, const Camera& camera);

/// Adds settings to the scene, such as "set aperture 0.1": options and their values. Throws EditRefusal.
TextEdits WithSettings(const ScnPlaces& places, const std::vector<std::pair<std::string, std::string>>& settings);

// Materials are indices into Scene::materials, of those that a statement has made.

/// Returns the last statement of this command, "mirror" or "gloss", for the material; std::nullopt if there is none.
std::optional<std::uint32_t> AboutMaterial(const ScnPlaces& places, std::size_t material, const std::string& command);
/// Adds a line with the command after the material. `numbers`: its arguments after the material's number.
TextEdits WithAboutMaterial(const ScnPlaces& places, std::size_t material, const std::string& command,
                            const std::string& numbers);
/// Returns the name of the material's image, as written in the scene; empty for none.
std::string TextureOf(const ScnPlaces& places, std::size_t material);
TextEdits WithTexture(const ScnPlaces& places, std::size_t material, const std::string& name);

/// The last statement of `command` in the top file; empty if there is none.
std::optional<std::uint32_t> LastOf(const ScnPlaces& places, const std::string& command);

/// Returns a decimal number near `value`, with 12 significant digits.
double Decimal(double value);

}  // namespace ray
