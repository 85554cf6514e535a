#pragma once

#include <optional>
#include <set>
#include <string>

#include "R2/ImageFile.h"

namespace ray::rayimg {

/// What the picture says under the key; empty when it says nothing.
std::string Setting(const R2::ImageSettings& settings, const std::string& key);

/// Whether both say the same under the key, and not nothing.
bool Agree(const R2::ImageSettings& a, const R2::ImageSettings& b, const std::string& key);

/// The seeds behind a picture: one, or those of all that were merged into it.
std::set<std::string> Seeds(const R2::ImageSettings& settings);

/// Why two pictures hold the same random numbers, as far as they tell: "'a.exr' and 'b.exr' are the same file", or of
/// one scene or command with a seed in common, for the numbers of a pixel's first samples depend on nothing else.
std::optional<std::string> WhyDependent(const std::string& a_name, const R2::ImageSettings& a,
                                        const std::string& b_name, const R2::ImageSettings& b);

}  // namespace ray::rayimg
