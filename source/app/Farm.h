#pragma once

#include "source/app/options/RenderOptions.h"

/// raypro's part in rendering one image on many machines: it divides, plans and lists missing parts. Assembling is a
/// render that starts with the samples of the parts.
namespace ray {

/// If options.render.part is set, renders that part into its file, for one round; blocks that the file already contains
/// are not rendered again. Otherwise prints the parts of options.missing that remain to be rendered in this round, one
/// number per line. If none remain, it decides on the next round and writes its plan; it prints nothing if only
/// assembling is left. With -time the first call also writes a plan, since time counts from then on.
///   returns   the exit status
int DoShareOfImage(const RenderOptions& options);

}  // namespace ray
