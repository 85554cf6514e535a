#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/render/RenderSettings.h"

/// Checks for likely mistakes in scenes, as tables of questions.
namespace ray {

/// The effort of the checks: those of every render, those that a render also makes unless it is quiet, or those of
/// -check.
enum class Effort { warning, hint, check };

/// The subject of the checks.
struct Inspection {
  const World& world;
  const RenderSettings& settings;
  const Accelerator* accelerator = nullptr;  // for the world, with Effort::hint
  Effort effort = Effort::check;
};

/// A fault of single shapes, reported in one line at the first shape that has it.
struct ShapeFault {
  const char* message;  // "this shape ..."
  bool (*is_of)(const Instance&, const Inspection&);
};
/// A fault of the scene as a whole: the message; empty if there is none.
using SceneFault = std::string (*)(const Inspection&);
/// Faults with positions: lines as they are printed.
using PlacedFaults = std::vector<std::string> (*)(const Inspection&);

struct Question {
  Effort effort;  // applies at this one and in -check
  std::variant<ShapeFault, SceneFault, PlacedFaults> fault;
};

/// Returns the lines about faults, in the order of the questions.
std::vector<std::string> Ask(std::span<const Question> questions, const Inspection& inspection);

/// Reports meshes that mode whitted treats as many lamps, and scenes for which the modes whitted and path, which
/// interpret emission differently, make images with very different light. A render checks in mode whitted if that takes
/// no more than some milliseconds.
std::vector<std::string> LampMistakes(const Inspection& inspection);

/// Reports surfaces of different materials in one plane if the camera sees them or one is a lamp, and lights inside
/// solids; in -check also clear meshes with holes, and clear solids that claim the same place without a priority or are
/// hidden by a higher priority.
std::vector<std::string> ContactMistakes(const Inspection& inspection);

/// Returns "room.scn:12:1: warning: " for an instance, "room.scn: warning: " for the scene.
std::string WarningAt(const World& world, const Instance& instance);
std::string WarningAt(const Scene& scene);
/// Returns " (and 3 more)" for four, and an empty text for one.
std::string AndMore(std::size_t count);

}  // namespace ray
