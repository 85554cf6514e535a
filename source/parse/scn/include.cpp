#include "source/parse/scn/ScnReader.h"

namespace ray {
namespace {

void ReadInclude(ScnReader& reader, Statement& statement) { reader.Include(statement, statement.FileName()); }

}  // namespace

extern const Command include_command{"include", "include file",
                                     "the contents of another file, which has material ids of its own", ReadInclude};

}  // namespace ray
