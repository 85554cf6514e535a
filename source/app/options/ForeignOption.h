#pragma once

#include <string>

#include "source/app/options/Program.h"

namespace ray {

/// The answer to what users of other renderers type: "; did you mean '-samples 4'?" for "-spp4", "--spp" and "--spp=4".
/// Empty for a word that no other renderer has either. A plus and a letter begin an option of POV-Ray.
std::string ForeignHint(const Program& program, const std::string& word);
/// Whether the word begins like an option of POV-Ray: with a plus and a letter.
bool IsOfPovRay(const std::string& word);

}  // namespace ray
