#include "source/scene/CameraText.h"

#include <numbers>
#include <sstream>
#include <vector>

#include "source/text/Number.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

constexpr const char *view_word = "view", *mirrored_word = "mirrored", *projection_word = "projection";

/// Returns " view 0 0 0 mirrored projection fisheye 180": the settings that differ from a centered pinhole.
std::string ViewWords(const Camera& camera) {
  std::string words;
  if (camera.aspect != 0 || camera.shift.x != 0 || camera.shift.y != 0 || camera.IsMirrored())
    words += std::string(" ") + view_word + " " + ToText(camera.aspect) + " " + ToText(camera.shift.x) + " " +
             ToText(camera.shift.y);
  if (camera.IsMirrored()) words += std::string(" ") + mirrored_word;
  if (camera.IsPinhole()) return words;
  words += std::string(" ") + projection_word + " " + camera.kind->name;
  return camera.extent > 0 ? words + " " + ToText(camera.extent) : words;
}

/// Removes "projection fisheye 180" from the end of the line, if present, and sets it. Returns false if it is invalid.
bool TakeProjection(std::string& line, Camera& camera) {
  const std::size_t at = line.find(projection_word);
  if (at == std::string::npos) return true;
  std::istringstream words(line.substr(at));
  std::string word, name, number;
  words >> word >> name >> number;
  camera.kind = FindCameraKind(name);
  if (!camera.kind || words >> word) return false;
  line.resize(at);
  if (number.empty()) return true;
  const auto [value, problem] = ParseNumber(number);
  camera.extent = value;
  return !problem && IsExtent(*camera.kind, value);
}

}  // namespace

std::string CameraLine(const Camera& camera) {
  std::string line = "camera";
  const auto triple = [&](double x, double y, double z) {
    line += " " + ToText(x) + " " + ToText(y) + " " + ToText(z) + " ";
  };
  triple(camera.eye.x, camera.eye.y, camera.eye.z);
  triple(camera.towards.x, camera.towards.y, camera.towards.z);
  triple(camera.up.x, camera.up.y, camera.up.z);
  line += " " + ToText(camera.xfov) + "  " + ToText(camera.near) + " " + ToText(camera.far);
  return line + ViewWords(camera);
}

std::optional<Camera> ReadCameraLine(const std::string& text) {
  constexpr std::size_t of_camera = 12, of_view = 3;
  Camera projected;
  std::string line = text;
  if (!TakeProjection(line, projected)) return {};
  std::istringstream words(line);
  std::string word;
  if (!(words >> word) || word != "camera") return {};
  std::vector<double> n;
  bool is_mirrored = false;
  while (words >> word) {
    if (is_mirrored) return {};
    if (n.size() == of_camera && word == view_word) continue;
    is_mirrored = n.size() == of_camera + of_view && word == mirrored_word;
    if (is_mirrored) continue;
    const auto [value, problem] = ParseNumber(word);
    if (problem) return {};
    n.push_back(value);
  }
  if (n.size() != of_camera && n.size() != of_camera + of_view) return {};
  n.resize(of_camera + of_view);
  const R3::Vector towards{n[3], n[4], n[5]}, up{n[6], n[7], n[8]};
  const bool is_angle = n[9] > 0 && n[9] < std::numbers::pi / 2;
  if (towards == R3::Vector{} || !is_angle || n[12] < 0) return {};
  Camera camera = Aim({n[0], n[1], n[2]}, towards, up).camera;
  camera.xfov = n[9];
  camera.near = n[10];
  camera.far = n[11];
  camera.aspect = n[12];
  camera.shift = {n[13], n[14]};
  if (is_mirrored) camera.right = -camera.right;
  camera.kind = projected.kind;
  camera.extent = projected.extent;
  return camera;
}

}  // namespace ray
