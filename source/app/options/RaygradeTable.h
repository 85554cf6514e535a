#pragma once

#include <vector>

#include "source/app/options/OptionTable.h"

namespace ray::raygrade {

std::vector<OptionKind> GradingOptions();

}  // namespace ray::raygrade
