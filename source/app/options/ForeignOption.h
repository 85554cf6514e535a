#pragma once

#include <span>
#include <string>

#include "source/app/options/Program.h"

namespace ray {

/// What users of other renderers type, and what to type here.
struct ForeignOption {
  const char* word;    // with its dash; with a plus, what begins one of POV-Ray's
  const char* answer;  // our option, or a phrase where we have none; several entries where programs differ
};
std::span<const ForeignOption> ForeignOptions();

/// "; did you mean '-samples 4'?" for "-spp4", "--spp" and "--spp=4"; empty where the table has nothing that the
/// program can do. A plus and a letter begin an option of POV-Ray.
std::string ForeignHint(Program program, const std::string& word);
bool IsOfPovRay(const std::string& word);

}  // namespace ray
