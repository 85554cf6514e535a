#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "source/accelerate/Accelerator.h"
#include "source/render/RenderSettings.h"

/// Likely mistakes of scenes, as tables of questions.
namespace ray {

/// How closely one looks: at what every render does, at what it hints at unless it is to be quiet, or as -check does.
enum class Effort { warning, hint, check };

/// What is looked at.
struct Inspection {
  const World& world;
  const RenderSettings& settings;
  const Accelerator* accelerator = nullptr;  // of the world, with Effort::hint
  Effort effort = Effort::check;
};

/// A fault of single shapes, told in one line at the first that has it.
struct ShapeFault {
  const char* message;  // "this shape ..."
  bool (*is_of)(const Instance&, const Inspection&);
};
/// A fault of the scene as a whole: the message; empty where there is none.
using SceneFault = std::string (*)(const Inspection&);
/// Faults that know their places: lines as they are printed.
using PlacedFaults = std::vector<std::string> (*)(const Inspection&);

struct Question {
  Effort effort;  // it is asked at this one and in -check
  std::variant<ShapeFault, SceneFault, PlacedFaults> fault;
};

/// The lines for what is wrong, in the order of the questions.
std::vector<std::string> Ask(std::span<const Question> questions, const Inspection& inspection);

/// Names meshes that mode whitted takes for many lamps, and scenes of which the modes whitted and path, which read
/// emission differently, make images of very different light. A render asks in mode whitted where that takes no more
/// than some milliseconds.
std::vector<std::string> LampMistakes(const Inspection& inspection);

/// Names surfaces of different materials in one plane where the camera sees them or one is a lamp, and lights inside of
/// solids; in -check also clear meshes with holes, and clear solids that claim the same place without a priority or
/// that a higher priority hides.
std::vector<std::string> ContactMistakes(const Inspection& inspection);

/// "room.scn:12:1: warning: " for an instance, "room.scn: warning: " for the scene.
std::string WarningAt(const World& world, const Instance& instance);
std::string WarningAt(const Scene& scene);
/// " (and 3 more)" of four, nothing of one.
std::string AndMore(std::size_t count);

}  // namespace ray
