#pragma once

#include <optional>
#include <set>
#include <string>

#include "R2/ImageFile.h"

namespace ray::rayimg {

/// Returns the image's value for the key; empty if there is none.
std::string Setting(const R2::ImageSettings& settings, const std::string& key);

/// Returns true if both have the same nonempty value for the key.
bool Agree(const R2::ImageSettings& a, const R2::ImageSettings& b, const std::string& key);

/// Returns the seeds of an image: one, or those of all images that were merged into it.
std::set<std::string> Seeds(const R2::ImageSettings& settings);

/// Returns why two images contain the same random numbers, as far as their metadata show: "'a.exr' and 'b.exr' are the
/// same file", or that they are of one scene or command with a common seed, since the numbers of a pixel's first
/// samples depend on nothing else.
std::optional<std::string> WhyDependent(const std::string& a_name, const R2::ImageSettings& a,
                                        const std::string& b_name, const R2::ImageSettings& b);

}  // namespace ray::rayimg
