#include "source/parse/meshes/Tally.h"

namespace ray {

void Tally::Warn(const Text& file, Report& report, const std::string& one, const std::string& many) const {
  if (IsEmpty()) return;
  const std::string number = std::to_string(count_) + " ";
  const bool has_line = first_.line > 0;
  report.Warn(Place(file.name, first_.line, first_.column),
              count_ == 1 ? number + one : number + many + (has_line ? ", the first of them here" : ""));
}

void WarnOfAbsent(const Tally& normals, const Tally& uvs, const Text& file, Report& report) {
  normals.Warn(file, report, "use of a normal that is not finite counts as none",
               "uses of normals that are not finite count as none");
  uvs.Warn(file, report, "use of texture coordinates that are not finite counts as 0 0",
           "uses of texture coordinates that are not finite count as 0 0");
}

}  // namespace ray
