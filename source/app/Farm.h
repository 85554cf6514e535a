#pragma once

#include "source/app/options/RenderOptions.h"

/// What raypro does where many machines render one image: it cuts, plans and says what is missing. Assembling is a
/// render that begins with the samples of the parts.
namespace ray {

/// Where options.render.part is set, renders it into its file, for one round; the blocks that the file holds already
/// are not rendered again. Otherwise prints the parts of options.missing that are to be rendered in this round, a
/// number per line. Where none are, it decides on the next round and writes its plan; it prints nothing when all that
/// is left is assembling. With -time the first call writes a plan, too, since time counts from then on.
///   returns   the exit status
int DoShareOfImage(const RenderOptions& options);

}  // namespace ray
