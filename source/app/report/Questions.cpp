#include "source/app/report/Questions.h"

#include <algorithm>

#include "source/app/report/Check.h"
#include "source/text/Quoting.h"

namespace ray {
namespace {

std::vector<std::string> LinesOn(const ShapeFault& fault, const Inspection& inspection) {
  const auto& instances = inspection.world.Instances();
  const auto has_fault = [&](const Instance& instance) { return fault.is_of(instance, inspection); };
  const auto first = std::ranges::find_if(instances, has_fault);
  if (first == instances.end()) return {};
  const auto count = std::count_if(first, instances.end(), has_fault);
  return {WarningAt(inspection.world, *first) + fault.message + AndMore(static_cast<std::size_t>(count))};
}

std::vector<std::string> LinesOn(SceneFault fault, const Inspection& inspection) {
  const std::string message = fault(inspection);
  if (message.empty()) return {};
  return {WarningAt(inspection.world.scene()) + message};
}

std::vector<std::string> LinesOn(PlacedFaults faults, const Inspection& inspection) { return faults(inspection); }

}  // namespace

std::vector<std::string> Ask(std::span<const Question> asked, const Inspection& inspection) {
  std::vector<std::string> lines;
  for (const Question& question : asked) {
    if (question.effort != inspection.effort && inspection.effort != Effort::check) continue;
    const auto more = std::visit([&](const auto& fault) { return LinesOn(fault, inspection); }, question.fault);
    lines.insert(lines.end(), more.begin(), more.end());
  }
  return lines;
}

std::string WarningAt(const World& world, const Instance& instance) { return PlaceOf(world, instance) + ": warning: "; }

std::string WarningAt(const Scene& scene) {
  return (scene.files.empty() ? "scene" : Escaped(scene.files[0])) + ": warning: ";
}

std::string AndMore(std::size_t count) { return count > 1 ? " (and " + std::to_string(count - 1) + " more)" : ""; }

}  // namespace ray
