#include "source/app/manual/Manual.h"

#include "R2/ImageFile.h"
#include "R3/ShapeKind.h"
#include "source/accelerate/Accelerator.h"
#include "source/app/options/Preset.h"
#include "source/integrate/Integrators.h"
#include "source/parse/Format.h"
#include "source/parse/scn/Command.h"
#include "source/scene/CameraKind.h"
#include "source/scene/Light.h"

namespace ray {
namespace {

constexpr std::size_t column_of_description = 14;

std::string Line(std::string name, const std::string& about) {
  name.resize(std::max(column_of_description, name.size() + 1), ' ');
  return "  " + name + about + "\n";
}

/// Returns "sphere x y z r" for a kind of shape or light with these ArgumentNames.
template <class Kind>
std::string LineWithArguments(const Kind& kind, const std::string& names) {
  return Line(kind.name, std::string(kind.about) + " (" + names.substr(1) + ")");
}

std::string Shapes() {
  std::string text;
  for (const R3::ShapeKind* kind : R3::ShapeKinds()) text += LineWithArguments(*kind, ArgumentNames(*kind));
  return text;
}

std::string Lights() {
  std::string text;
  for (const LightKind* kind : LightKinds()) text += LineWithArguments(*kind, ArgumentNames(kind->arguments));
  return text;
}

std::string Projections() {
  std::string text;
  for (const CameraKind* kind : CameraKinds()) text += Line(kind->name, kind->about);
  return text;
}

std::string Accelerators() {
  std::string text;
  for (const AcceleratorKind* kind : AcceleratorKinds()) text += Line(kind->name, kind->about);
  return text;
}

std::string Modes() {
  std::string text;
  for (std::size_t i = 0; i < render_modes.size(); ++i) text += Line(render_modes[i], IntegratorKinds()[i]->about);
  return text;
}

std::string Images() {
  std::string text;
  for (const R2::ImageFormat& format : R2::ImageFormats()) {
    std::string extensions;
    for (const char* extension : format.extensions)
      extensions += (extensions.empty() ? "." : " .") + std::string(extension);
    text += Line(format.name, extensions);
  }
  return text;
}

std::string OfFormat(const SceneFormat& format) {
  std::string extensions;
  for (const char* extension : format.extensions)
    extensions += (extensions.empty() ? "" : " ") + std::string(extension);
  return Line(format.name, extensions + "  " + format.about);
}

std::string Scenes() {
  std::string text;
  for (const SceneFormat* format : SceneFormats()) text += OfFormat(*format);
  return text;
}

std::string SceneCommands() {
  std::string text;
  for (const std::string_view name : CommandNames()) text += "  " + FindCommand(name)->usage + "\n";
  return text;
}

std::string PresetLines() {
  std::string text;
  for (const Preset& preset : Presets()) {
    std::string settings;
    for (const auto& [option, value] : preset.settings) settings += " -" + std::string(option) + " " + value;
    text += Line(preset.name, std::string(preset.about) + ":" + settings);
  }
  return text;
}

std::string Indented(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += "  " + line + "\n";
  return text;
}

struct Subject {
  const char* name;
  std::string (*list)();  // null for the keys of the viewer, which only that program has
};

constexpr Subject list_subjects[] = {
    {"shapes", Shapes},       {"lights", Lights}, {"projections", Projections}, {"accelerators", Accelerators},
    {"modes", Modes},         {"images", Images}, {"scenes", Scenes},           {"commands", SceneCommands},
    {"presets", PresetLines}, {"keys", nullptr}};

/// Returns true if the program has the subject: presets are values of an option that only raypro has; keys need a
/// window.
bool Knows(const Program& program, const Subject& subject) {
  return program == Program::raypro ? subject.list != nullptr : subject.list != PresetLines;
}

}  // namespace

std::vector<std::string> ListSubjects(const Program& program) {
  std::vector<std::string> names;
  for (const Subject& subject : list_subjects)
    if (Knows(program, subject)) names.emplace_back(subject.name);
  return names;
}

std::string Listing(const Program& program, const std::string& wanted, const std::vector<std::string>& keys) {
  std::string text;
  for (const Subject& subject : list_subjects)
    if (Knows(program, subject) && (wanted.empty() || wanted == subject.name))
      text += subject.name + std::string(":\n") + (subject.list ? subject.list() : Indented(keys));
  return text;
}

}  // namespace ray
