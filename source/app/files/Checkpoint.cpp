#include "source/app/files/Checkpoint.h"

#include <filesystem>

#include "source/app/Status.h"
#include "source/app/files/Outputs.h"
#include "source/app/options/OptionTable.h"
#include "source/app/report/Messages.h"
#include "source/parse/Files.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"
#include "source/text/Quoting.h"

namespace ray {
namespace {

void RemoveFile(const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
}

}  // namespace

std::string IdentityOf(const RenderOptions& options, const std::string& scene_hash) {
  std::string text = "version " RAYPRO_VERSION "\nscene " + scene_hash + "\n";
  for (const OptionKind& option : OptionTable(*options.program)) {
    const bool shows = option.facts.HasAny({Fact::image, Fact::samples, Fact::budget});
    if (!shows || option.facts.Has(Fact::changes_on_resume)) continue;
    text += "-" + std::string(option.name) + " " + options.Show(option) + "\n";
  }
  return text;
}

Checkpoint::Checkpoint(const FileOptions& files, const CheckpointOptions& options, bool is_of_course)
    : image_name_(files.image),
      has_image_(IsFinishedImage(image_name_)),
      beside_(CheckOutput(image_name_ + ".checkpoint", InputsOf(files))),
      aside_(CheckOutput(PartialName(image_name_) + ".checkpoint", InputsOf(files))),
      had_aside_(IsThere(aside_.target)) {
  if (const OutputFile* found = Found(); found && !options.resume && !options.restart)
    throw UsageError("there is a checkpoint of an earlier render, " + QuotedPath(found->name) + "; " +
                     (is_of_course ? "remove it to render from the start"
                                   : "-resume continues from it, -restart renders from the start and removes it"));
}

const OutputFile* Checkpoint::Found() const {
  return IsThere(aside_.target) ? &aside_ : IsThere(beside_.target) ? &beside_ : nullptr;
}

void Checkpoint::Save(const RenderState& state, const std::string& identity) {
  try {
    WriteWhole(has_image_ ? aside_ : beside_, Encoded(state, identity));
    if (!has_image_) RemoveFile(aside_.target);  // the render continued from it, and must not go back to it
    RemoveCopy();
  } catch (const OutputError& error) {
    if (!error.kept_as.empty()) kept_as_ = error.kept_as;
    PrintError("raypro: warning: " + std::string(error.what()));
  }
}

RenderState Checkpoint::Load(const Film& film, const RenderSettings& settings, const std::string& identity) const {
  const OutputFile* const found = Found();
  const std::string& name = found ? found->name : Name();
  try {
    const Files files(name, {});
    const std::string bytes = files.Read(files.Top());
    RenderState state =
        DecodedState({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, identity, film);
    CheckPlan(state, settings);
    CheckState(state, film, settings);
    return state;
  } catch (const FileError& error) {
    throw SceneErrors({ErrorIn(name, "cannot resume: " + error.message)});
  } catch (const CheckpointError& error) {
    throw SceneErrors({ErrorIn(name, "cannot resume: " + std::string(error.what()))});
  }
}

void Checkpoint::Remove() {
  RemoveFile(beside_.target);
  RemoveFile(aside_.target);
  RemoveCopy();
}

void Checkpoint::ImageIsFinished(bool keep) {
  std::error_code ignored;
  if (!keep) Remove();
  if (keep && has_image_) std::filesystem::rename(aside_.target, beside_.target, ignored);
  if (had_aside_) RemoveFile(PartialName(image_name_));
}

void Checkpoint::RemoveCopy() {
  if (!kept_as_.empty()) RemoveFile(kept_as_);
  kept_as_.clear();
}

}  // namespace ray
