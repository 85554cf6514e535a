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

/// Gives a field other values, as many as it has; a number that stays keeps its spelling. Throws EditRefusal.
TextEdits WithValues(const ScnPlaces& places, std::uint32_t statement, const ScnField& field,
                     const std::vector<double>& values);

/// Moves a shape, light, line or group by `way`, in the coordinates of the statement. Everything else, such as a mesh,
/// gets a group around it that moves it. Sums are rounded to 12 digits. Throws EditRefusal.
TextEdits Moved(const ScnPlaces& places, std::uint32_t statement, const R3::Vector& way);

/// Takes out a shape, light or mesh, or a group with all that is in it: with its lines and the comment at their end
/// where nothing else is on them. Throws EditRefusal for what others refer to, such as a material.
TextEdits Removed(const ScnPlaces& places, std::uint32_t statement);

/// A copy behind the statement, or behind the group that it opens, moved by `way`; and the offset of the copy.
struct Copied {
  TextEdits edits;
  std::size_t begin = 0;
};
Copied Duplicated(const ScnPlaces& places, std::uint32_t statement, const R3::Vector& way);

/// Makes the scene's camera stand and look as this one, to the bit; a scene without a camera gets one. A camera of the
/// words look_at keeps them where they say as much. Projection and shift are not edited. Throws EditRefusal.
TextEdits WithCamera(const ScnPlaces& places, const Camera& camera);

/// Adds settings to the scene, such as "set aperture 0.1": options and their values. Throws EditRefusal.
TextEdits WithSettings(const ScnPlaces& places, const std::vector<std::pair<std::string, std::string>>& settings);

// Materials are said by an index into Scene::materials, one that a statement has made.

/// The statement that says more of the material by this command, "mirror" or "gloss", last; nothing where none does.
std::optional<std::uint32_t> AboutMaterial(const ScnPlaces& places, std::size_t material, const std::string& command);
/// Says more of the material in a line behind it. `numbers`: what the command takes behind the material's number.
TextEdits WithAboutMaterial(const ScnPlaces& places, std::size_t material, const std::string& command,
                            const std::string& numbers);
/// The name of the image that the material's statement gives it, as the scene says it; empty for none.
std::string TextureOf(const ScnPlaces& places, std::size_t material);
TextEdits WithTexture(const ScnPlaces& places, std::size_t material, const std::string& name);

/// The statement that `command` begins last in the top file; nothing where there is none.
std::optional<std::uint32_t> LastOf(const ScnPlaces& places, const std::string& command);

/// A decimal near `value`: with 12 digits that count.
double Decimal(double value);

}  // namespace ray
