#include "source/render/RenderState.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "source/render/PassRunner.h"
#include "source/text/Hash.h"

namespace ray {
namespace {

constexpr std::string_view magic = "raypro checkpoint 6\n";

std::uint64_t Checksum(std::span<const unsigned char> bytes) {
  Hash hash;
  hash.Add(bytes);
  return hash.Value();
}

class Writer {
 public:
  template <typename T>
  void Put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    const auto* first = reinterpret_cast<const unsigned char*>(&value);
    bytes_.insert(bytes_.end(), first, first + sizeof(T));
  }
  template <typename T>
  void PutAll(const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    Put<std::uint64_t>(values.size());
    const auto* first = reinterpret_cast<const unsigned char*>(values.data());
    bytes_.insert(bytes_.end(), first, first + values.size() * sizeof(T));
  }
  /// Writes the values of all blocks, or a flag that there are none.
  template <typename T>
  void PutIfAny(const std::vector<T>& values) {
    Put(!values.empty());
    if (!values.empty()) PutAll(values);
  }
  void PutText(std::string_view text) { bytes_.insert(bytes_.end(), text.begin(), text.end()); }
  std::vector<unsigned char> Take() { return std::move(bytes_); }
  std::span<const unsigned char> Bytes() const { return bytes_; }

 private:
  std::vector<unsigned char> bytes_;
};

class Reader {
 public:
  explicit Reader(std::span<const unsigned char> bytes) : rest_(bytes) {}

  template <typename T>
  T Take() {
    T value;
    const auto taken = TakeBytes(sizeof(T));
    std::memcpy(&value, taken.data(), sizeof(T));
    return value;
  }
  /// Reads exactly as many values as `values` has elements.
  template <typename T>
  void TakeAll(std::vector<T>& values) {
    if (Take<std::uint64_t>() != values.size()) throw CheckpointError("it belongs to an image of a different size");
    const auto taken = TakeBytes(values.size() * sizeof(T));
    std::ranges::copy(taken,
                      reinterpret_cast<unsigned char*>(values.data()));  // memcpy takes no null, even for nothing
  }
  /// Reads the values that PutIfAny has written.
  template <typename T>
  void TakeIfAny(std::vector<T>& values, int blocks) {
    if (Take<char>() == 0) return;
    values.resize(static_cast<std::size_t>(blocks));
    TakeAll(values);
  }
  std::string TakeText(std::uint64_t length) {
    const auto taken = TakeBytes(length);
    return {taken.begin(), taken.end()};
  }
  std::size_t Left() const { return rest_.size(); }

 private:
  std::span<const unsigned char> TakeBytes(std::uint64_t count) {
    if (count > rest_.size()) throw CheckpointError("it is truncated");
    const auto taken = rest_.first(static_cast<std::size_t>(count));
    rest_ = rest_.subspan(taken.size());
    return taken;
  }

  std::span<const unsigned char> rest_;
};

/// Returns the first line in which the two differ, as the first has it: "-seed 0", or "-fresnel " for a missing option.
std::string FirstDifference(std::string_view a, std::string_view b) {
  while (!a.empty()) {
    const std::string_view line_a = a.substr(0, a.find('\n')), line_b = b.substr(0, b.find('\n'));
    if (line_a != line_b) return std::string(line_a);
    a.remove_prefix(std::min(a.size(), line_a.size() + 1));
    b.remove_prefix(std::min(b.size(), line_b.size() + 1));
  }
  return {};
}

/// Writes an estimate field by field, since padding between fields is uninitialized.
void PutError(Writer& writer, const ErrorEstimate& error) {
  ErrorEstimate::ForEachField(error, [&](const auto& field) { writer.Put(field); });
}

ErrorEstimate TakeError(Reader& reader) {
  ErrorEstimate error;
  ErrorEstimate::ForEachField(error, [&]<class T>(T& field) { field = reader.Take<T>(); });
  return error;
}

void PutPass(Writer& writer, const Pass& pass) {
  writer.Put(pass.end);
  writer.Put(pass.samples);
  writer.Put(pass.seconds);
  writer.Put(pass.error.has_value());
  if (pass.error) PutError(writer, *pass.error);
}

Pass TakePass(Reader& reader) {
  Pass pass;
  pass.end = reader.Take<std::uint32_t>();
  pass.samples = reader.Take<double>();
  pass.seconds = reader.Take<double>();
  if (reader.Take<char>() != 0) pass.error = TakeError(reader);
  return pass;
}

void PutSchedule(Writer& writer, const ScheduleState& schedule) {
  writer.PutAll(schedule.targets.samples);
  writer.PutIfAny(schedule.targets.places);
  writer.Put(schedule.end);
}

ScheduleState TakeSchedule(Reader& reader, int blocks) {
  ScheduleState schedule;
  schedule.targets.samples.resize(static_cast<std::size_t>(blocks));
  reader.TakeAll(schedule.targets.samples);
  reader.TakeIfAny(schedule.targets.places, blocks);
  schedule.end = reader.Take<std::uint32_t>();
  return schedule;
}

void PutBlock(Writer& writer, const Film::Block& block) {
  for (int part = 0; part < Film::parts; ++part) {
    writer.Put(block.samples[part]);
    if (block.samples[part] > 0) writer.PutAll(block.sums[part].Sums());
  }
  writer.Put(static_cast<std::uint8_t>(block.first_samples.size()));
  writer.PutAll(block.first_samples);
}

Film::Block TakeBlock(Reader& reader, const BlockSums& empty) {
  Film::Block block;
  for (int part = 0; part < Film::parts; ++part) {
    block.samples[part] = reader.Take<std::uint32_t>();
    if (block.samples[part] == 0) continue;
    block.sums[part] = empty;
    reader.TakeAll(block.sums[part].Sums());
  }
  block.first_samples.resize(reader.Take<std::uint8_t>());
  reader.TakeAll(block.first_samples);
  return block;
}

/// Returns the bytes between the first line of a checkpoint and its checksum, after checking both.
std::span<const unsigned char> CheckedBody(std::span<const unsigned char> bytes) {
  if (bytes.size() < magic.size() || !std::equal(magic.begin(), magic.end(), bytes.begin()))
    throw OtherImageError("it is not a checkpoint of this version");
  std::uint64_t checksum = 0;
  if (bytes.size() < magic.size() + sizeof checksum) throw CheckpointError("it is truncated");
  const auto checked = bytes.first(bytes.size() - sizeof checksum);
  std::memcpy(&checksum, checked.data() + checked.size(), sizeof checksum);
  if (checksum != Checksum(checked)) throw CheckpointError("it is truncated or damaged");
  return checked.subspan(magic.size());
}

void Require(bool is_so, const char* what) {
  if (!is_so) throw CheckpointError(std::string("the checkpoint is inconsistent: ") + what);
}

bool AreSquares(const std::vector<double>& squares) {
  return std::ranges::all_of(squares, [](double square) { return square >= 0; });
}

/// Checks that blocks are due samples, or places within their first sample.
void CheckSchedule(const ScheduleState& schedule, std::uint32_t most) {
  const PassTargets& targets = schedule.targets;
  const auto is_due = [&](std::uint32_t samples) {
    return samples <= most && (samples > 0 || !targets.places.empty());
  };
  Require(schedule.end <= most && schedule.end == std::ranges::max(targets.samples) &&
              std::ranges::all_of(targets.samples, is_due),
          "more samples due than its settings allow");
  Require(std::ranges::all_of(targets.places, [](int places) { return places <= BlockOrder::places; }),
          "more places due than a block has");
}

void CheckPass(const Pass& pass, std::uint32_t most) {
  Require(pass.end <= most, "a pass with more samples than its settings allow");
  Require(pass.samples >= 0 && pass.seconds >= 0, "a pass of negative length");
  Require(!pass.error || (pass.error->unit >= ErrorUnit::display && pass.error->unit <= ErrorUnit::linear),
          "an error in an unknown unit");
}

/// Returns true if the parts are two streams with equally many samples, or contain the samples up to a power of two and
/// those after it.
bool ArePartsOfOneBlock(const Film::Block& block, bool has_two_streams) {
  if (has_two_streams) return block.samples[0] == block.samples[1];
  const std::uint64_t all = std::uint64_t{block.samples[0]} + block.samples[1];
  return block.samples[0] == (all > 1 ? std::bit_floor(all - 1) : all);
}

void CheckBlock(const Film::Block& block, const Film& film, std::uint32_t target, bool has_two_streams) {
  Require(ArePartsOfOneBlock(block, has_two_streams), "the samples of a block are split wrongly");
  const std::uint64_t second = has_two_streams ? 0 : block.samples[1];
  Require(block.samples[0] + second <= target, "a block with more samples than were due");
  Require(block.first_samples.size() <= (block.Samples() == 0 ? BlockOrder::places : 0u),
          "looks at a block that has samples");
  for (int part = 0; part < Film::parts; ++part)
    for (const WeightedSum& sum : block.sums[part].Sums())
      Require(film.filter().IsBox() ? sum.weight == block.samples[part] : std::isfinite(sum.weight),
              "a pixel whose weight is not that of its samples");
}

}  // namespace

std::vector<unsigned char> Encoded(const RenderState& state, const std::string& identity) {
  Writer writer;
  writer.PutText(magic);
  writer.Put<std::uint64_t>(identity.size());
  writer.PutText(identity);
  PutSchedule(writer, state.schedule);
  writer.Put(state.rays);
  writer.Put(state.planned_samples);
  writer.PutIfAny(state.differences.squares);
  if (!state.differences.IsEmpty()) writer.PutAll(state.differences.samples);
  writer.Put<std::uint64_t>(state.passes.size());
  for (const Pass& pass : state.passes) PutPass(writer, pass);
  for (const Film::Block& block : state.blocks) PutBlock(writer, block);
  writer.Put(Checksum(writer.Bytes()));
  return writer.Take();
}

RenderState DecodedState(std::span<const unsigned char> bytes, const std::string& identity, const Film& film) {
  Reader reader(CheckedBody(bytes));
  const auto length = reader.Take<std::uint64_t>();
  const std::string theirs = reader.TakeText(length);
  if (theirs != identity) {
    const std::string difference = FirstDifference(theirs, identity);
    if (difference.starts_with("scene "))  // a hash is meaningless to readers
      throw OtherImageError("the checkpoint belongs to a different scene");
    if (difference.ends_with(' '))
      throw OtherImageError("the checkpoint was made without " + difference.substr(0, difference.size() - 1));
    throw OtherImageError("the checkpoint was made with " + difference);
  }
  RenderState state;
  state.schedule = TakeSchedule(reader, film.Blocks());
  state.rays = reader.Take<RayCounts>();
  state.planned_samples = reader.Take<std::uint32_t>();
  reader.TakeIfAny(state.differences.squares, film.Blocks());
  state.differences.samples.resize(state.differences.squares.size());
  if (!state.differences.IsEmpty()) reader.TakeAll(state.differences.samples);
  for (auto passes = reader.Take<std::uint64_t>(); passes > 0; --passes) state.passes.push_back(TakePass(reader));
  for (int i = 0; i < film.Blocks(); ++i) state.blocks.push_back(TakeBlock(reader, film.EmptySums(i)));
  if (reader.Left() > 0) throw CheckpointError("it has extra bytes at its end");
  return state;
}

void CheckPlan(const RenderState& state, const RenderSettings& settings) {
  const std::uint32_t then = state.planned_samples, now = PlannedSamples(settings);
  if (then == now) return;
  const std::uint64_t due =
      (HasTwoStreams(settings) ? 2 : 1) * std::uint64_t{std::ranges::max(state.schedule.targets.samples)};
  if (due > now)
    throw CheckpointError("the checkpoint contains " + std::to_string(due) + " samples per pixel, more than -samples " +
                          std::to_string(now) + ": samples can be added but not removed");
  const auto refuse = [&](const std::string& why) {
    throw CheckpointError("the checkpoint's samples were planned for " + std::to_string(then) + " per pixel, not " +
                          std::to_string(now) + ": " + why);
  };
  if (std::min(then, now) == 1) refuse("a single sample is in the middle of its pixel, the first of several is not");
  if (settings.budget.error) refuse("with -error, earlier decisions would have been different");
  const SamplerKind sampler = settings.trace.sampler;
  if (sampler == SamplerKind::stratified || IsGrid(sampler))
    refuse(std::string("the ") + sampler_names[static_cast<std::size_t>(sampler)] +
           " sampler plans all samples in advance");
  if (settings.filter == FilterKind::box) return;
  // A filter that spreads samples adds up the pixels of a block step by step.
  for (const Film::Block& block : state.blocks)
    if (!PassRunner::IsStepEnd(block.Samples()))
      refuse("with a filter other than box, samples can be added to 1, 2, 4, ... 64, 128, 192, ...");
}

void CheckState(const RenderState& state, const Film& film, const RenderSettings& settings) {
  const std::uint32_t most = MostSamples(settings);
  CheckSchedule(state.schedule, most);
  for (const Pass& pass : state.passes) CheckPass(pass, most);
  Require(AreSquares(state.differences.squares), "a squared error that is negative");
  for (std::size_t i = 0; i < state.blocks.size(); ++i)
    CheckBlock(state.blocks[i], film, state.schedule.targets.samples[i], HasTwoStreams(settings));
}

}  // namespace ray
