#include "source/app/files/Checkpoint.h"

#include <filesystem>

#include "source/app/Status.h"
#include "source/app/files/Outputs.h"
#include "source/app/options/OptionTable.h"
#include "source/app/report/Messages.h"
#include "source/parse/Files.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"

namespace ray {
namespace {

/// Everything that a bit of the picture depends on: version, scene, and the options that choose it.
std::string Identity(const Options& options, const std::string& scene_hash) {
  std::string text = "version " RAYPRO_VERSION "\nscene " + scene_hash + "\n";
  for (const OptionKind& option : OptionTable(options.program)) {
    const std::string topic = option.topic, name = option.name;
    if (!IsSetting(option) || (topic != "picture" && topic != "light" && topic != "quality")) continue;
    if (name == "checkpoint" || name == "resume" || name == "reference" || name == "time") continue;
    if (name == "keep_checkpoint" || name == "samples") continue;
    text += "-" + name + " " + Show(option, options) + "\n";
  }
  return text;
}

}  // namespace

Checkpoint::Checkpoint(const Options& options)
    : options_(options), file_(CheckOutput(options.picture + ".checkpoint", InputsOf(options))) {}

bool Checkpoint::Exists() const {
  std::error_code ignored;
  return std::filesystem::exists(file_.target, ignored);
}

void Checkpoint::Save(const RenderState& state, const std::string& scene_hash) {
  try {
    WriteWhole(file_, Encoded(state, Identity(options_, scene_hash)));
    RemoveCopy();
  } catch (const OutputError& error) {
    if (!error.kept_as.empty()) kept_as_ = error.kept_as;
    PrintError("raypro: warning: " + std::string(error.what()));
  }
}

RenderState Checkpoint::Load(const Film& film, const RenderSettings& settings, const std::string& scene_hash) const {
  try {
    const Files files(file_.name, {});
    const std::string bytes = files.Read(files.Top());
    RenderState state = DecodedState({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()},
                                     Identity(options_, scene_hash), film);
    CheckPlan(state, settings);
    CheckState(state, film, settings);
    return state;
  } catch (const FileError& error) {
    throw SceneErrors({ErrorIn(file_.name, "cannot resume: " + error.message)});
  } catch (const CheckpointError& error) {
    throw SceneErrors({ErrorIn(file_.name, "cannot resume: " + std::string(error.what()))});
  }
}

void Checkpoint::Remove() {
  std::error_code ignored;
  std::filesystem::remove(file_.target, ignored);
  RemoveCopy();
}

void Checkpoint::RemoveCopy() {
  std::error_code ignored;
  if (!kept_as_.empty()) std::filesystem::remove(kept_as_, ignored);
  kept_as_.clear();
}

}  // namespace ray
