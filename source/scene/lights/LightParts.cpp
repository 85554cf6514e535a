#include "source/scene/lights/LightParts.h"

#include "source/text/NumberText.h"

namespace ray {
namespace {

std::string Triple(double a, double b, double c) { return Words(a) + " " + Words(b) + " " + Words(c); }

}  // namespace

std::string Words(double number) { return ToText(number); }
std::string Words(const R2::Color& color) { return Triple(color.r, color.g, color.b); }
std::string Words(const R3::Point& place) { return Triple(place.x, place.y, place.z); }
std::string Words(const R3::Vector& direction) {
  constexpr int digits = 5;  // of a unit vector, which has 16 although the scene's author wrote a few
  return Rounded(direction.x, digits) + " " + Rounded(direction.y, digits) + " " + Rounded(direction.z, digits);
}

}  // namespace ray
