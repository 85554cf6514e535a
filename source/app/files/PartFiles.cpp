#include "source/app/files/PartFiles.h"

#include <glob.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <map>

#include "source/app/Status.h"
#include "source/app/files/Outputs.h"
#include "source/app/files/ReadInputs.h"
#include "source/app/files/TemporaryFile.h"
#include "source/app/report/Messages.h"
#include "source/parse/SceneError.h"
#include "source/parse/Text.h"
#include "source/render/Parts.h"
#include "source/text/NumberText.h"
#include "source/text/Quoting.h"

namespace ray {
namespace {

constexpr const char* byte_order = std::endian::native == std::endian::little ? "little-endian" : "big-endian";
constexpr std::string_view first_word = "raypro ", plan_title = "plan after ";
constexpr std::size_t most_compressed = 1032;  // the largest compression ratio of deflate

std::string TitleOf(const ImagePart& part) {
  return "part " + std::to_string(part.index) + " of " + std::to_string(part.of);
}

/// Returns a compressed file. Its head is a line "raypro part 3 of 8, little-endian, 123456 bytes".
std::vector<unsigned char> Packed(const std::string& title, const std::vector<unsigned char>& bytes) {
  const std::string head =
      std::string(first_word) + title + ", " + byte_order + ", " + std::to_string(bytes.size()) + " bytes\n";
  uLongf size = compressBound(bytes.size());
  std::vector<unsigned char> packed(head.begin(), head.end());
  packed.resize(head.size() + size);
  if (compress2(packed.data() + head.size(), &size, bytes.data(), bytes.size(), Z_BEST_SPEED) != Z_OK)
    throw std::bad_alloc();
  packed.resize(head.size() + size);
  return packed;
}

struct Unpacked {
  std::string title;
  std::vector<unsigned char> bytes;
};

/// Returns the text up to the next `end`, and removes both.
std::string TakeUpTo(std::string_view end, std::string_view& text) {
  const std::size_t at = text.find(end);
  if (at == std::string_view::npos) throw CheckpointError("it is truncated or damaged");
  const std::string taken(text.substr(0, at));
  text.remove_prefix(at + end.size());
  return taken;
}

/// Unpacks a file of Packed; throws CheckpointError for anything else.
Unpacked UnpackedFrom(std::string_view text) {
  if (!text.starts_with(first_word)) throw CheckpointError("it is truncated or damaged");
  text.remove_prefix(first_word.size());
  Unpacked unpacked{TakeUpTo(", ", text), {}};
  if (TakeUpTo(", ", text) != byte_order) throw OtherImageError("it was made on a machine of another byte order");
  const std::string number = TakeUpTo(" bytes\n", text);
  std::size_t size = 0;
  const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), size);
  if (error != std::errc() || stop != number.data() + number.size() || size > most_compressed * text.size())
    throw CheckpointError("it is truncated or damaged");
  unpacked.bytes.resize(size);
  uLongf got = size, used = text.size();
  const int result =
      uncompress2(unpacked.bytes.data(), &got, reinterpret_cast<const unsigned char*>(text.data()), &used);
  if (result != Z_OK || got != size || used != text.size()) throw CheckpointError("it is truncated or damaged");
  return unpacked;
}

std::optional<ImagePart> PartTitled(const std::string& title) {
  ImagePart part;
  std::string_view text = title;
  if (!text.starts_with("part ")) return {};
  const auto take = [&text](std::string_view before, int& number) {
    if (!text.starts_with(before)) return false;
    text.remove_prefix(before.size());
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
    return error == std::errc();
  };
  const bool is_title = take("part ", part.index) && take(" of ", part.of) && text.empty();
  if (!is_title || part.index < 1 || part.index > part.of || part.of > most_image_parts) return {};
  return part;
}

/// Returns the number of seconds after the start of its render at which a plan was written.
double SecondsTitled(const std::string& title) {
  const bool is_plan = title.starts_with(plan_title);
  const char *begin = title.data() + (is_plan ? plan_title.size() : 0), *end = title.data() + title.size();
  double seconds = 0;
  const auto [stop, error] = std::from_chars(begin, end, seconds);
  if (!is_plan || error != std::errc() || std::string_view(stop, end) != " s" || !(seconds >= 0))
    throw CheckpointError("it is not a plan of a round");
  return seconds;
}

/// Returns the text escaped for a pattern, so that these characters are literal.
std::string Literal(const std::string& text, std::string_view special) {
  std::string pattern;
  for (const char letter : text) {
    if (special.find(letter) != std::string_view::npos) pattern += '\\';
    pattern += letter;
  }
  return pattern;
}

std::vector<std::string> Matches(const std::string& pattern) {
  glob_t found = {};
  std::vector<std::string> names;
  if (glob(pattern.c_str(), 0, nullptr, &found) == 0) names.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  return names;
}

[[noreturn]] void RefusePart(const std::string& name, const std::string& why) {
  throw SceneErrors({ErrorIn(name, "cannot be used for this image: " + why)});
}

}  // namespace

std::string PartName(const std::string& image_name, const ImagePart& part) {
  return image_name + ".part-" + std::to_string(part.index) + "-of-" + std::to_string(part.of);
}

std::string PlanName(const std::string& image_name) { return image_name + ".plan"; }

std::vector<std::string> FilesLike(const std::string& pattern, const std::string& image_name) {
  if (IsThere(pattern)) return {pattern};
  const std::size_t at = pattern.rfind('/') + 1;  // 0 without a folder
  std::string begin = pattern.substr(0, at), rest = pattern.substr(at);
  if (IsThere(begin)) begin = Literal(begin, "*?[\\");
  const std::string own = std::filesystem::path(image_name).filename().string();
  if (rest.starts_with(own)) {
    begin += Literal(own, "*?[\\");
    rest.erase(0, own.size());
  }
  const std::vector<std::string> names = Matches(begin + Literal(rest, "[\\"));
  return names.empty() ? Matches(begin + rest) : names;
}

PartReader::PartReader(const RenderSettings& settings, const std::string& image_name, const std::string& identity)
    : settings_(settings), image_name_(image_name), identity_(identity), film_(EmptyFilmOf(settings)) {}

const std::vector<int>& PartReader::PartsOf(int of) {
  if (of != of_) parts_ = PartsOfBlocks(film_, of);
  of_ = of;
  return parts_;
}

RenderState PartReader::Decoded(std::span<const unsigned char> bytes) const {
  RenderState state = DecodedState(bytes, identity_, film_);
  if (state.planned_samples != PlannedSamples(settings_))
    throw OtherImageError("its samples were planned for " + std::to_string(state.planned_samples) + " per pixel, not " +
                          std::to_string(PlannedSamples(settings_)));
  CheckState(state, film_, settings_);
  return state;
}

std::optional<PartFile> PartReader::Read(const std::string& name) {
  try {
    const Unpacked unpacked = UnpackedFrom(Contents(name));
    const auto part = PartTitled(unpacked.title);
    if (!part) throw CheckpointError("it is not a part of an image");
    PartFile file{*part, Decoded(unpacked.bytes)};
    CheckPart(file.state, part->index, PartsOf(part->of));
    return file;
  } catch (const OtherImageError& error) {
    RefusePart(name, error.what());
  } catch (const CheckpointError& error) {
    PrintError(QuotedPath(name) + ": warning: " + error.what() + "; its content is rendered again");
    return {};
  } catch (const SceneErrors&) {
    if (IsThere(name)) throw;
    return {};
  }
}

Plan PartReader::ReadPlan(const std::string& name) const {
  try {
    const Unpacked unpacked = UnpackedFrom(Contents(name));
    const double seconds = SecondsTitled(unpacked.title);
    return {seconds, Decoded(unpacked.bytes)};
  } catch (const CheckpointError& error) {
    RefusePart(name, error.what());
  }
}

RenderState PartReader::Round() const {
  const std::string name = PlanName(image_name_);
  return IsThere(name) ? ReadPlan(name).state : FirstRound(settings_, film_);
}

std::optional<double> PartReader::SecondsSinceBegin() const {
  const std::string name = PlanName(image_name_);
  if (!IsThere(name)) return {};
  const std::chrono::duration<double> since =
      TemporaryFile(name).Time() - std::filesystem::last_write_time(name);
  return ReadPlan(name).seconds + std::max(0.0, since.count());
}

RenderState PartReader::Joined(const std::vector<std::string>& names, int of) {
  struct Known {
    std::string file;
    double samples;
    RayCounts rays;
  };
  std::map<int, Known> known;
  RenderState round = Round();
  for (const std::string& name : names) {
    auto file = Read(name);
    if (!file) continue;
    const auto& [index, their_of] = file->part;
    if (of == 0) of = their_of;
    if (their_of != of)
      RefusePart(name, "it is one of " + std::to_string(their_of) + " parts, others are of " + std::to_string(of));
    const Known now{name, SamplesOf(file->state), file->state.rays};
    const auto [earlier, is_new] = known.try_emplace(index, now);
    if (!is_new && !Agree(round, file->state))
      RefusePart(name, "it differs from " + QuotedPath(earlier->second.file) +
                           ", which is the same part; remove the wrong one");
    if (!is_new && now.samples <= earlier->second.samples) continue;
    earlier->second = now;
    TakeBlocks(round, std::move(file->state), index, PartsOf(of));
  }
  for (const auto& [index, part] : known) round.rays += part.rays;
  return round;
}

RenderState StateOfParts(PartReader&& reader, const std::string& pattern) {
  const std::vector<std::string> names = FilesLike(pattern, reader.ImageName());
  if (names.empty())
    PrintError("raypro: warning: no file is named " + Quoted(pattern) + "; the whole image is rendered here");
  return reader.Joined(names, 0);
}

PartWriter::PartWriter(const RenderSettings& settings, const FileOptions& files, const std::string& identity)
    : settings_(settings), files_(files), identity_(identity) {}

void PartWriter::WritePart(RenderState&& state) const {
  const ImagePart& part = *settings_.part;
  WriteWhole(CheckOutput(PartName(files_.image, part), InputsOf(files_)),
             Packed(TitleOf(part), Encoded(ForPartFile(std::move(state)), identity_)));
}

void PartWriter::WritePlan(RenderState&& state, double seconds) const {
  const Film film = EmptyFilmOf(settings_);
  WriteWhole(CheckOutput(PlanName(files_.image), InputsOf(files_)),
             Packed(std::string(plan_title) + Fixed(seconds, 3) + " s",
                    Encoded(WithoutSamples(std::move(state), film), identity_)));
}

}  // namespace ray
