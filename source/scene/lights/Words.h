#pragma once

#include <string>

#include "R2/Color.h"
#include "R3/Point.h"

/// Numbers in the descriptions of lights: shortest form that reads back the same, whatever the locale.
namespace ray {

std::string Words(double number);
std::string Words(const R2::Color& color);
std::string Words(const R3::Point& place);
std::string Words(const R3::Vector& direction);

}  // namespace ray
