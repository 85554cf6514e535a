#pragma once

#include <string>

#include "R2/Color.h"
#include "R3/Point.h"

/// Numbers as panels show them: rounded, so that they fit beside one another.
namespace ray {

std::string Brief(double number);
std::string Brief(const R2::Color& color);
std::string Brief(const R3::Point& point);
std::string Brief(const R3::Vector& vector);
/// Words with their numbers rounded, where those stand between blanks or before commas.
std::string Brief(const std::string& words);

}  // namespace ray
