#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ray {

/// Returns the bytes of a file; std::nullopt if it cannot be read.
std::optional<std::string> ReadSceneFile(const std::string& file);

/// Returns the first free name in the folder of the file: "room-2.scn" for "room.scn", or "room-3.scn".
std::string FreeCopyName(const std::string& file);

/// The scenes and meshes in the folder of a file, by name, each as the file itself is named: with its folder, if it has
/// one. At most 1000 of them.
std::vector<std::string> ScenesBeside(const std::string& file);

/// Returns the file that many places behind `file`, or before it, in a cycle. Empty if there is no other.
std::string NeighborOf(const std::string& file, const std::vector<std::string>& scenes, int by);

}  // namespace ray
