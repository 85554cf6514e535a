#pragma once

#include <string>
#include <vector>

#include "source/app/options/ViewerOptions.h"
#include "source/scene/Scene.h"
#include "source/view/ViewerHost.h"

/// rayview's options that can be changed while it runs.
namespace ray {

/// Returns the options that affect images and can still be changed, in the order of the option table.
std::vector<ShownOption> OptionsOfPanels(const ViewerOptions& options);

/// Returns the options as if all current values had been typed, with this value of one option of OptionsOfPanels, empty
/// for its default. The scene's settings count as typed, the samples of the default image do not. Throws UsageError.
ViewerOptions WithOption(const Scene& scene, const ViewerOptions& options, const std::string& name,
                         const std::string& value);

}  // namespace ray
