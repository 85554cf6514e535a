#pragma once

#include <string>
#include <vector>

#include "source/app/options/ViewerOptions.h"
#include "source/view/ViewerHost.h"

/// rayview's options, to be changed while it runs.
namespace ray {

/// The options that bear on images and can still be changed, in the order of the option table.
std::vector<ShownOption> OptionsOfPanels(const ViewerOptions& options);

/// The options as if all that is in force had been typed, with this value of one option of OptionsOfPanels, empty for
/// its default. What the scene set counts as typed. Throws UsageError.
ViewerOptions WithOption(const ViewerOptions& options, const std::string& name, const std::string& value);

}  // namespace ray
