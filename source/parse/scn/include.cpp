#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

void ReadInclude(ScnReader& reader, Statement& statement) { reader.Include(statement, statement.Word("file")); }

}  // namespace

extern const Command include_command{"include", "include file", "what another file states, as if it stood here",
                                     ReadInclude};

}  // namespace ray
