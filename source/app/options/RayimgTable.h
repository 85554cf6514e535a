#pragma once

#include <span>
#include <vector>

#include "source/app/options/OptionTable.h"

/// The commands of rayimg, and their options.
namespace ray::rayimg {

std::span<const CommandKind> Commands();
std::vector<OptionKind> OptionsOfCommands();

/// Throws UsageError where options of the command contradict each other, or one is missing.
void CheckTogether(const CommandKind& command, const ImageOptions& options);

}  // namespace ray::rayimg
