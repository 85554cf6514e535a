#pragma once

#include <optional>
#include <string>

#include "source/render/RenderSettings.h"

namespace ray {

/// Parses "90", "90s", "5m", "1.5h": seconds, above 0; std::nullopt for anything else.
std::optional<double> ReadDuration(const std::string& word);
/// Returns "90s"; "" for 0, which means none.
std::string ShowDuration(const double& seconds);

/// Parses "1.5", "3%", "40dB", "0.01lin": an error and its unit. std::nullopt for anything else, or for an error not
/// above 0.
std::optional<std::optional<ErrorTarget>> ReadErrorTarget(const std::string& word);
std::string ShowErrorTarget(const std::optional<ErrorTarget>& target);

/// Parses "16", or a share of the pixels "1/2", "1/4", "1/8" or "1/16"; returns false for anything else.
bool ReadSamples(const std::string& word, RenderSettings& render);
std::string ShowSamples(const RenderSettings& render);

/// Parses "all" as 0, "one" as 1, "auto" as -1, or an integer above 0.
std::optional<int> ReadLightCount(const std::string& word);
std::string ShowLightCount(const int& count);

/// Parses "3/8", the third of eight parts; std::nullopt for anything else.
std::optional<std::optional<ImagePart>> ReadPart(const std::string& word);
std::string ShowPart(const std::optional<ImagePart>& part);

}  // namespace ray
