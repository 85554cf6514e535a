#include "source/view/SceneReader.h"

#include <filesystem>
#include <utility>

#include "source/render/forecast/SecondsOf.h"

namespace ray {

void SceneReader::Read(const std::string& file, const ParseOptions& parse, const AcceleratorSettings& how, bool is_edit,
                       Show show, Refuse refuse) {
  file_ = file, is_edit_ = is_edit;
  show_ = std::move(show), refuse_ = std::move(refuse);
  begin_ = std::chrono::steady_clock::now();
  job_.Begin([file, parse, how] { return std::make_shared<const LoadedScene>(file, parse, how); });
  Update();
}

void SceneReader::Update(bool waits) {
  if (!job_.IsBusy() || (!waits && !job_.IsComplete())) return;
  // They may read another scene.
  const Show show = std::exchange(show_, nullptr);
  const Refuse refuse = std::exchange(refuse_, nullptr);
  try {
    Scene scene = *job_.Take(true);
    seconds_ = SecondsSince(begin_);
    show(std::move(scene));
  } catch (const std::exception& error) {
    refuse(error);
  }
}

std::string SceneReader::Describe() const {
  if (!IsBusy()) return {};
  const auto seconds = static_cast<int>(SecondsSince(begin_));
  return "reading " + std::filesystem::path(file_).filename().string() +
         (seconds > 0 ? ", " + std::to_string(seconds) + " s" : "");
}

}  // namespace ray
