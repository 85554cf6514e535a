#include "source/view/FileReader.h"

#include <filesystem>
#include <utility>

#include "source/render/forecast/SecondsOf.h"

namespace ray {

void FileReader::Begin(const std::string& file, bool is_edit, Read read, Refuse refuse) {
  file_ = file, is_edit_ = is_edit;
  refuse_ = std::move(refuse);
  begin_ = std::chrono::steady_clock::now();
  job_.Begin(std::move(read));
  Update();
}

void FileReader::Update(bool waits) {
  if (!job_.IsBusy() || (!waits && !job_.IsComplete())) return;
  const Refuse refuse = std::exchange(refuse_, nullptr);  // either may read another file
  try {
    const Show show = *job_.Take(true);
    seconds_ = SecondsSince(begin_);
    show();
  } catch (const std::exception& error) {
    refuse(error);
  }
}

std::string FileReader::Describe() const {
  if (!IsBusy()) return {};
  const auto seconds = static_cast<int>(SecondsSince(begin_));
  return "reading " + std::filesystem::path(file_).filename().string() +
         (seconds > 0 ? ", " + std::to_string(seconds) + " s" : "");
}

}  // namespace ray
