#pragma once

#include <optional>
#include <string>

#include "source/render/RenderSettings.h"

namespace ray {

/// "90", "90s", "5m", "1.5h": seconds, above 0; nothing for anything else.
std::optional<double> ReadDuration(const std::string& word);
/// "90s"; "" for 0, which stands for none.
std::string ShowDuration(const double& seconds);

/// "1.5", "3%", "40dB", "0.01lin": an error and its unit. Nothing for anything else, or for an error not above 0.
std::optional<std::optional<ErrorTarget>> ReadErrorTarget(const std::string& word);
std::string ShowErrorTarget(const std::optional<ErrorTarget>& target);

/// "16", or of the pixels "1/2", "1/4", "1/8" or "1/16"; false for anything else.
bool ReadSamples(const std::string& word, RenderSettings& render);
std::string ShowSamples(const RenderSettings& render);

/// "all" is 0, "one" is 1, or a whole number above 0; "auto" is -1.
std::optional<int> ReadLightCount(const std::string& word);
std::string ShowLightCount(const int& count);

/// "3/8", the third of eight parts. Nothing for anything else.
std::optional<std::optional<ImagePart>> ReadPart(const std::string& word);
std::string ShowPart(const std::optional<ImagePart>& part);

}  // namespace ray
