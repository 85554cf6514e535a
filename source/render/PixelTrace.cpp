#include "source/render/PixelTrace.h"

#include <algorithm>

#include "source/render/Render.h"
#include "source/render/RenderBlock.h"
#include "source/render/Schedule.h"
#include "source/text/EnumNames.h"
#include "source/text/NumberText.h"

namespace ray {
namespace {

/// The conversion of a tree's numbers to text: with the digits that a reader compares, or with all of them.
struct NumberTexts {
  Digits digits;

  std::string operator()(double number) const {
    constexpr int few = 5;
    return digits == Digits::all ? ToText(number) : Rounded(number, few);
  }
  std::string operator()(double x, double y, double z) const {
    return (*this)(x) + " " + (*this)(y) + " " + (*this)(z);
  }
  std::string operator()(const R3::Point& p) const { return (*this)(p.x, p.y, p.z); }
  std::string operator()(const R3::Vector& v) const { return (*this)(v.x, v.y, v.z); }
  std::string operator()(const R2::Color& c) const { return (*this)(c.r, c.g, c.b); }
};

/// Writes the rays of one pixel, each below its parent.
class TreeWriter {
 public:
  TreeWriter(const PixelTrace& trace, const World& world, std::size_t most_rays, Digits digits)
      : trace_(trace), world_(world), text_of_{digits}, left_(most_rays), children_(trace.Children()) {}

  std::string Write() {
    std::size_t sample = 0;
    for (std::size_t i = 0; i < trace_.rays.size(); ++i) {
      if (trace_.rays[i].parent != RecordedRay::none) continue;
      sample = WriteSamplesWithoutRay(sample);
      WriteSample(sample++);
      WriteFrom(i);
    }
    WriteSamplesWithoutRay(sample);
    if (cut_ > 0) text_ += std::to_string(cut_) + " more rays are not shown\n";
    return std::move(text_);
  }

 private:
  /// Writes the samples from number `i` on that have no recorded ray. Returns the number of the next sample with one.
  std::size_t WriteSamplesWithoutRay(std::size_t i) {
    for (; i < trace_.samples.size() && !trace_.samples[i].HasRay(); ++i) {
      const CameraSample& taken = trace_.samples[i];
      text_ += "sample " + std::to_string(i + 1) + " at " + text_of_(taken.x) + " " + text_of_(taken.y) +
               ": outside the camera's view, so it is black and no ray is traced\n";
    }
    return i;
  }

  void WriteSample(std::size_t i) {
    const CameraSample& taken = trace_.samples[i];
    text_ += "sample " + std::to_string(i + 1) + " at " + text_of_(taken.x) + " " + text_of_(taken.y) + ": " +
             text_of_(trace_.radiances[i]);
    if (trace_.Counted(i) != trace_.radiances[i]) text_ += ", clamped to " + text_of_(trace_.Counted(i));
    text_ += "\n";
  }

  /// Writes a tree depth first, with a stack: trees may be as deep as the reflections between facing mirrors.
  void WriteFrom(std::size_t root) {
    std::vector<std::pair<std::size_t, int>> open{{root, 1}};
    while (!open.empty()) {
      const auto [i, indent] = open.back();
      open.pop_back();
      for (auto child = children_[i].rbegin(); child != children_[i].rend(); ++child)
        open.emplace_back(*child, indent + 1);
      if (left_ == 0) {
        ++cut_;
        continue;
      }
      --left_;
      WriteRay(trace_.rays[i], indent);
    }
  }

  void WriteRay(const RecordedRay& ray, int indent) {
    constexpr int deepest_indent = 40;  // columns
    const std::string margin(static_cast<std::size_t>(std::min(2 * indent, deepest_indent)), ' ');
    text_ += margin + ray_kind_names[static_cast<std::size_t>(ray.kind)] + " ray";
    if (ray.is_outlined) text_ += ", on an outline, which is black";
    if (!ray.towards.empty()) text_ += " to " + LightText(ray.towards);
    text_ += "\n" + margin + "  from " + text_of_(ray.ray.origin) + " along " + text_of_(ray.ray.direction);
    if (ray.is_inside) text_ += ", inside";
    text_ += ", throughput " + text_of_(ray.throughput) + "\n";
    text_ += margin + "  " + End(ray) + ", contributes " + text_of_(ray.contribution) + "\n";
  }

  /// Returns a light in full at its first mention, afterwards its number.
  std::string LightText(const std::string& light) {
    const auto known = std::ranges::find(lights_, light);
    const std::string name = "light " + std::to_string(known - lights_.begin() + 1);
    if (known != lights_.end()) return name;
    lights_.push_back(light);
    return name + ", " + light;
  }

  std::string End(const RecordedRay& ray) const {
    if (!ray.at) return ray.kind == RayKind::shadow ? "unoccluded" : "hits nothing";
    const Instance& instance = world_.Instances()[ray.hit->instance];
    const Location& where = instance.node->location;
    std::string text = ray.kind == RayKind::shadow ? "blocked by " : "hits ";
    text += "primitive " + std::to_string(world_.PrimitiveId(*ray.hit));
    if (where.line > 0) text += " of " + world_.scene().files[where.file] + ":" + std::to_string(where.line);
    text += " at t " + text_of_(ray.hit->t) + ", " + text_of_(ray.at->position);
    if (ray.kind == RayKind::shadow) return text;
    text += ", normal " + text_of_(AsVector(ray.at->normal));
    if (!(ray.at->shading_normal == ray.at->normal))
      text += ", shading normal " + text_of_(AsVector(ray.at->shading_normal));
    return text + ", uv " + text_of_(ray.at->uv.x) + " " + text_of_(ray.at->uv.y);
  }

  const PixelTrace& trace_;
  const World& world_;
  NumberTexts text_of_;
  std::size_t left_, cut_ = 0;
  const std::vector<std::vector<std::size_t>> children_;
  std::vector<std::string> lights_;  // in the order of their first mention
  std::string text_;
};

int StreamsOf(const RenderSettings& settings) { return HasTwoStreams(settings) ? 2 : 1; }

}  // namespace

R2::Color PixelTrace::Mean() const {
  R2::Color sum;
  for (std::size_t i = 0; i < radiances.size(); ++i) sum += Counted(i);
  return radiances.empty() ? sum : sum / static_cast<double>(radiances.size());
}

std::vector<std::vector<std::size_t>> PixelTrace::Children() const {
  std::vector<std::vector<std::size_t>> children(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (rays[i].parent != RecordedRay::none) children[static_cast<std::size_t>(rays[i].parent)].push_back(i);
  return children;
}

PixelTracer::PixelTracer(const World& world, const Accelerator& accelerator, const RenderSettings& settings)
    : seed_(settings.seed),
      clamps_samples_(settings.clamp == Clamp::samples),
      streams_(StreamsOf(settings)),
      integrator_(IntegratorOf(world, accelerator, settings)),
      camera_(CameraRaysOf(world, settings)) {}

PixelTrace PixelTracer::Trace(int column, int row, int samples) const {
  PixelTrace trace{column, row, {}, {}, {}, clamps_samples_};
  const SampleSource source{*integrator_, camera_, seed_, clamps_samples_};
  RayRecorder recorder;
  TraceState state;
  state.recorder = &recorder;
  for (int i = 0; i < samples; ++i) {
    const RandomKey key = source.PixelKey(column, row, i % streams_);
    const CameraSample& sample =
        trace.samples.emplace_back(camera_({column, row, key, static_cast<std::uint32_t>(i / streams_)}));
    TraceSamples(source, {&sample, 1}, {&trace.radiances.emplace_back(), 1}, state);
  }
  trace.rays = recorder.Rays();
  return trace;
}

std::string RayTree(const PixelTrace& trace, const World& world, const RenderSettings& settings, std::size_t most_rays,
                    Digits digits) {
  const bool is_left_out = IsSubsampled(settings) && BlockOrder::PlaceOf(trace.column, trace.row) >= settings.places;
  return "pixel " + std::to_string(trace.column) + " " + std::to_string(trace.row) + " of " +
         std::to_string(settings.width) + " x " + std::to_string(settings.height) + ", " + NameOf(settings.mode) +
         ": " + NumberTexts{digits}(trace.Mean()) +
         (ShowsCosts(settings.mode) ? ", a cost of rays that contribute light" : "") +
         (trace.samples.size() > 1 ? ", the mean of " + std::to_string(trace.samples.size()) + " samples" : "") +
         (settings.shares_light && !world.Moves() ? ", by its own paths: the image's pixels share light" : "") +
         (is_left_out ? ", skipped by -samples: the image interpolates the pixels around it" : "") + "\n" +
         (world.scene().is_mirrored ? "in the right-handed world of raypro: each z is the negative of the file's\n"
                                    : "") +
         TreeWriter(trace, world, most_rays, digits).Write();
}

PixelTrace TracePixel(const World& world, const Accelerator& accelerator, const RenderSettings& settings, int column,
                      int row) {
  const int streams = StreamsOf(settings), samples = streams * std::max(1, settings.samples / streams);
  return PixelTracer(world, accelerator, settings).Trace(column, row, samples);
}

std::string DebugPixel(const World& world, const Accelerator& accelerator, const RenderSettings& settings, int column,
                       int row, Digits digits) {
  return RayTree(TracePixel(world, accelerator, settings, column, row), world, settings, most_rays_of_tree, digits);
}

}  // namespace ray
