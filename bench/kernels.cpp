// Our accelerators beside Embree: the same scenes, the same rays, one process, one thread, taking turns; medians
// of the thread's own time.
//
//     make bench && build/bench/kernels [scene=a,b] [accel=bvh,grid] [rays=N] [repeats=N] [turn=4096] [robust=1]
//                                       [simd=avx2] [build=1] [resolution=x] [counts=1] [packet=16]
//                                       [kind=primary,shadow] [peer=0] [peer_packet=8|16]
//                                       [peer_quality=low|medium|high]
//
// With `turn` the engines take turns every so many rays instead of after all of them, so that each finds caches that
// the others have filled, as it would between shading and film.
//
// Columns are millions of rays a second, the ratio to Embree's, and wrong answers, theirs + ours: where the two differ
// (a hit against none, or over 1e-3 apart) every triangle is tested in double precision to decide who is wrong.

#include <tbb/global_control.h>
#include <tbb/info.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>
#include <random>
#include <span>
#include <sstream>

#include "bench/BenchScenes.h"
#include "bench/Embree.h"
#include "source/accelerate/Accelerator.h"
#include "source/scene/Node.h"

namespace {

using Rays = std::vector<R3::Ray>;
using Seconds = std::chrono::duration<double>;

struct Kind {
  std::string name;
  Rays rays;
  bool any = false, is_coherent = false;
};

constexpr std::size_t most_rays_of_packet = 256;

double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double Time(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return Seconds(std::chrono::steady_clock::now() - start).count();
}

/// Seconds that this thread was at work, so that what else the machine does counts less.
double ThreadTime(const std::function<void()>& work) {
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

R3::Vector Float(const R3::Vector& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// A mesh as a scene with nothing else.
ray::Scene SceneOf(const R3::MeshData& data) {
  ray::Scene scene;
  ray::Node node;
  node.shape = std::make_shared<R3::Mesh>(data);
  SetBounds(node);
  scene.root.children.push_back(std::move(node));
  SetBounds(scene.root);
  return scene;
}

/// Rays of all kinds, each from where the ones before have hit.
std::vector<Kind> MakeRays(const bench::View& view, const ray::World& world, const ray::Accelerator& accelerator,
                           std::size_t count) {
  const auto side = static_cast<int>(std::sqrt(static_cast<double>(count)));
  ray::Camera camera = ray::Aim(view.eye, view.target - view.eye, {0, 1, 0}).camera;
  camera.xfov = 0.5;
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> number(0, 1);
  ray::Workspace workspace;

  // From each hit: where it is, off the surface by what single precision needs, and a cosine-distributed direction.
  struct SpawnRay {
    R3::Point from;
    R3::Vector bounce;
  };
  const R3::Box bounds = world.scene().root.bounds;
  const double off = 1e-5 * bounds.Radius();
  const auto onward = [&](const R3::Ray& ray) -> std::optional<SpawnRay> {
    const auto hit = accelerator.Intersect(ray, workspace);
    if (!hit) return {};
    R3::Vector n = AsVector(world.At(ray, *hit).normal);
    if (Dot(n, ray.direction) > 0) n = -n;
    const double z = 2 * number(random) - 1, turn = 2 * M_PI * number(random), out = std::sqrt(1 - z * z);
    const R3::Vector bounce = Unit(n + 0.999 * R3::Vector{out * std::cos(turn), out * std::sin(turn), z});
    return SpawnRay{bench::Float(ray.At(hit->t) + off * n), Float(bounce)};
  };

  Kind primary{"primary", {}, false, true}, shadow{"shadow", {}, true, true}, diffuse{"diffuse", {}},
      third{"third", {}};
  constexpr int tile = 4;
  for (int ty = 0; ty < side; ty += tile)
    for (int tx = 0; tx < side; tx += tile)
      for (int y = ty; y < std::min(ty + tile, side); ++y)
        for (int x = tx; x < std::min(tx + tile, side); ++x) {
          R3::Ray ray = camera.Through(x + 0.5, y + 0.5, side, side);
          ray.origin = bench::Float(ray.origin), ray.direction = Float(ray.direction);
          primary.rays.push_back(ray);
          const auto first = onward(ray);
          if (!first) continue;
          shadow.rays.push_back({first->from, Float(view.light - first->from), 0, 1});
          diffuse.rays.push_back({first->from, first->bounce});
          auto next = onward(diffuse.rays.back());
          if (next) next = onward({next->from, next->bounce});
          if (next) third.rays.push_back({next->from, next->bounce});
        }
  Kind shuffled{"shuffled", third.rays.empty() ? diffuse.rays : third.rays};
  std::shuffle(shuffled.rays.begin(), shuffled.rays.end(), random);
  std::vector<Kind> kinds{primary, shadow, diffuse, third, shuffled};
  for (Kind& kind : kinds)  // as many of each, so that medians weigh alike
    for (std::size_t i = 0; !kind.rays.empty() && kind.rays.size() < count / 4; ++i) kind.rays.push_back(kind.rays[i]);
  return kinds;
}

struct Answers {
  std::vector<double> t;  // infinity for a miss, 0 for an occluded ray
  ray::Counts counts;
};

Answers Trace(const ray::Accelerator& accelerator, const Kind& kind, std::size_t packet = 1) {
  ray::Workspace workspace;
  Answers answers;
  answers.t.reserve(kind.rays.size());
  if (packet > 1 && kind.is_coherent) {
    std::optional<ray::WorldHit> hits[most_rays_of_packet];
    bool is_occluded[most_rays_of_packet];
    for (std::size_t first = 0; first < kind.rays.size(); first += packet) {
      const std::span rays(kind.rays.data() + first, std::min(packet, kind.rays.size() - first));
      if (kind.any)
        accelerator.IsOccluded(rays, is_occluded, workspace);
      else
        accelerator.Intersect(rays, hits, workspace);
      for (std::size_t i = 0; i < rays.size(); ++i)
        answers.t.push_back(kind.any ? (is_occluded[i] ? 0 : R3::infinity) : hits[i] ? hits[i]->t : R3::infinity);
    }
    answers.counts = workspace.counts;
    return answers;
  }
  for (const R3::Ray& ray : kind.rays) {
    if (kind.any) {
      answers.t.push_back(accelerator.IsOccluded(ray, workspace) ? 0 : R3::infinity);
    } else {
      const auto hit = accelerator.Intersect(ray, workspace);
      answers.t.push_back(hit ? hit->t : R3::infinity);
    }
  }
  answers.counts = workspace.counts;
  return answers;
}

Answers Trace(const embree::Scene& scene, const Kind& kind) {
  Answers answers;
  answers.t.reserve(kind.rays.size());
  for (const R3::Ray& ray : kind.rays) {
    embree::RayHit r{};
    for (int axis = 0; axis < 3; ++axis) {
      r.origin[axis] = static_cast<float>(ray.origin[axis]);
      r.direction[axis] = static_cast<float>(ray.direction[axis]);
    }
    r.near = 0, r.far = static_cast<float>(ray.t_max), r.mask = ~0u;
    if (kind.any)
      answers.t.push_back(scene.IsOccluded(r) ? 0 : R3::infinity);
    else
      answers.t.push_back(scene.Intersect(r) ? r.far : R3::infinity);
  }
  return answers;
}

/// In packets of Embree's own.
template <int size>
Answers TracePackets(const embree::Scene& scene, const Kind& kind) {
  Answers answers;
  answers.t.reserve(kind.rays.size());
  for (std::size_t first = 0; first < kind.rays.size(); first += size) {
    const std::size_t count = std::min<std::size_t>(size, kind.rays.size() - first);
    embree::RayHits<size> r;
    alignas(64) int valid[size];
    for (std::size_t i = 0; i < size; ++i) {
      valid[i] = i < count ? -1 : 0;
      const R3::Ray& ray = kind.rays[first + std::min(i, count - 1)];
      r.origin_x[i] = static_cast<float>(ray.origin.x), r.direction_x[i] = static_cast<float>(ray.direction.x);
      r.origin_y[i] = static_cast<float>(ray.origin.y), r.direction_y[i] = static_cast<float>(ray.direction.y);
      r.origin_z[i] = static_cast<float>(ray.origin.z), r.direction_z[i] = static_cast<float>(ray.direction.z);
      r.near[i] = 0, r.far[i] = static_cast<float>(ray.t_max), r.time[i] = 0;
      r.mask[i] = ~0u, r.id[i] = r.flags[i] = 0;
    }
    if (kind.any)
      scene.IsOccluded(r, valid);
    else
      scene.Intersect(r, valid);
    for (std::size_t i = 0; i < count; ++i)
      answers.t.push_back(kind.any                           ? (r.far[i] < 0 ? 0 : R3::infinity)
                          : r.geometry[i] == embree::nothing ? R3::infinity
                                                             : r.far[i]);
  }
  return answers;
}

/// In the order they come, `size` rays each; 0: all together.
std::vector<Kind> Turns(const Kind& kind, std::size_t size) {
  if (size == 0) return {kind};
  std::vector<Kind> turns;
  for (std::size_t first = 0; first < kind.rays.size(); first += size) {
    const std::span rays(kind.rays.data() + first, std::min(size, kind.rays.size() - first));
    turns.push_back({kind.name, {rays.begin(), rays.end()}, kind.any, kind.is_coherent});
  }
  return turns;
}

void Append(Answers& all, const Answers& more) {
  all.t.insert(all.t.end(), more.t.begin(), more.t.end());
  all.counts += more.counts;
}

struct Mistakes {
  int theirs = 0, ours = 0;
};

Mistakes Judge(const Kind& kind, const Answers& ours, const Answers& theirs, const ray::Accelerator& all) {
  const auto agree = [](double a, double b) { return a == b || std::abs(a - b) <= 1e-3 * std::abs(a); };
  Mistakes mistakes;
  for (std::size_t i = 0; i < ours.t.size(); ++i) {
    if (agree(ours.t[i], theirs.t[i])) continue;
    const double truth = Trace(all, {kind.name, {kind.rays[i]}, kind.any}).t[0];
    if (!agree(truth, theirs.t[i])) ++mistakes.theirs;
    if (truth == ours.t[i]) continue;
    ++mistakes.ours;
    const R3::Ray& r = kind.rays[i];
    std::fprintf(stderr, "wrong: {{%a, %a, %a}, {%a, %a, %a}} hits at %a, not %a\n", r.origin.x, r.origin.y, r.origin.z,
                 r.direction.x, r.direction.y, r.direction.z, truth, ours.t[i]);
  }
  return mistakes;
}

std::vector<std::string> Split(const std::string& text) {
  std::vector<std::string> parts;
  std::stringstream in(text);
  for (std::string part; std::getline(in, part, ',');) parts.push_back(part);
  return parts;
}

/// Seconds of the build on `threads` threads, the least of some.
template <typename Make>
double BuildSeconds(int threads, int repeats, const Make& make) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  double least = R3::infinity;
  for (int i = 0; i < repeats; ++i) least = std::min(least, Time(make));
  return least;
}

}  // namespace

int main(int argc, char** argv) {
  std::map<std::string, std::string> options{{"scene", ""},        {"accel", "bvh"}, {"rays", "1000000"},
                                             {"repeats", "5"},     {"robust", "0"},  {"peer_quality", "medium"},
                                             {"simd", "best"},     {"build", "0"},   {"resolution", "0"},
                                             {"peer", "1"},        {"counts", "0"},  {"packet", "1"},
                                             {"peer_packet", "1"}, {"kind", ""},     {"turn", "0"}};
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto sign = word.find('=');
    if (sign == std::string::npos || !options.contains(word.substr(0, sign))) {
      std::fprintf(stderr, "kernels: no option '%s'\n", argv[i]);
      return 2;
    }
    options[word.substr(0, sign)] = word.substr(sign + 1);
  }
  const auto scenes = options["scene"].empty() ? bench::SceneNames() : Split(options["scene"]);
  const auto accelerators = Split(options["accel"]), wanted = Split(options["kind"]);
  const std::string peer_packet = options["peer_packet"];
  const std::size_t packet = std::clamp<std::size_t>(std::stoul(options["packet"]), 1, most_rays_of_packet);
  const int repeats = std::stoi(options["repeats"]);
  const auto peer_quality = options["peer_quality"] == "high"  ? embree::high
                            : options["peer_quality"] == "low" ? embree::low
                                                               : embree::medium;

  const auto library = options["peer"] == "0" ? nullptr : embree::Library::Find();
  std::printf("%s; ours: %s\n", library ? library->name.c_str() : "Embree not found", options["simd"].c_str());
  std::map<std::string, std::map<std::string, std::vector<double>>> ratios;  // accelerator, kind
  for (const std::string& name : scenes) {
    const auto view = bench::MakeView(name);
    if (!view) {
      std::printf("%s: not here\n", name.c_str());
      continue;
    }
    const ray::Scene scene = SceneOf(view->mesh);
    const ray::World world(scene);
    std::vector<std::unique_ptr<const ray::Accelerator>> ours;
    for (const std::string& a : accelerators) {
      ray::AcceleratorSettings settings;
      settings.name = a;
      settings.instruction_set = options["simd"];
      settings.resolution = std::stod(options["resolution"]);
      settings.expected_rays = 1e9;
      const auto make = [&] { return ray::FindAcceleratorKind(a)->Make(world, settings); };
      ours.push_back(make());
      const double triangles = static_cast<double>(view->mesh.triangles.size());
      std::printf("%s: %.0f triangles, %s %.1f bytes a triangle", name.c_str(), triangles, a.c_str(),
                  static_cast<double>(ours.back()->Bytes()) / triangles);
      if (options["build"] != "0")
        std::printf(", built in %.3f s on 1 thread, %.3f s on 2", BuildSeconds(1, repeats, make),
                    BuildSeconds(2, repeats, make));
      std::printf("\n");
    }
    const auto all = ray::FindAcceleratorKind("none")->Make(world, {});
    std::unique_ptr<embree::Scene> theirs;
    if (library) {
      theirs = std::make_unique<embree::Scene>(*library, view->mesh, peer_quality, options["robust"] == "1");
      if (options["build"] != "0") {
        const double seconds = BuildSeconds(
            1, repeats, [&] { embree::Scene(*library, view->mesh, peer_quality, options["robust"] == "1"); });
        std::printf("%s: %s built in %.3f s (threads as EMBREE_CONFIG says)\n", name.c_str(), library->name.c_str(),
                    seconds);
      }
    }
    for (const Kind& kind : MakeRays(*view, world, *ours[0], std::stoul(options["rays"]))) {
      if (kind.rays.empty() || (!wanted.empty() && std::find(wanted.begin(), wanted.end(), kind.name) == wanted.end()))
        continue;
      std::vector<std::vector<double>> seconds(ours.size());
      std::vector<double> their_seconds;
      std::vector<Answers> answers;
      Answers their_answers;
      const std::vector<Kind> turns = Turns(kind, std::stoul(options["turn"]));
      for (int i = 0; i < repeats; ++i) {
        answers.assign(ours.size(), {});
        their_answers = {};
        their_seconds.push_back(0);
        for (auto& s : seconds) s.push_back(0);
        for (const Kind& turn : turns) {
          Answers now;
          if (theirs) {
            their_seconds.back() += ThreadTime([&] {
              now = peer_packet == "16"  ? TracePackets<16>(*theirs, turn)
                    : peer_packet == "8" ? TracePackets<8>(*theirs, turn)
                                         : Trace(*theirs, turn);
            });
            Append(their_answers, now);
          }
          for (std::size_t a = 0; a < ours.size(); ++a) {
            seconds[a].back() += ThreadTime([&] { now = Trace(*ours[a], turn, packet); });
            Append(answers[a], now);
          }
        }
      }
      const double million = 1e-6 * static_cast<double>(kind.rays.size());
      std::printf("%-12s %-9s", name.c_str(), kind.name.c_str());
      if (theirs) std::printf(" Embree %6.2f", million / Median(their_seconds));
      for (std::size_t a = 0; a < ours.size(); ++a) {
        std::printf("  %s %6.2f", accelerators[a].c_str(), million / Median(seconds[a]));
        const auto per_ray = [&](std::uint64_t n) { return 1e-6 * static_cast<double>(n) / million; };
        if (options["counts"] != "0")
          std::printf(" [%.1f nodes, %.1f leaves, %.2f asked]", per_ray(answers[a].counts.box_tests) / 8,
                      per_ray(answers[a].counts.node_visits) - per_ray(answers[a].counts.box_tests) / 8,
                      per_ray(answers[a].counts.primitive_tests));
        if (!theirs) continue;
        const double ratio = Median(their_seconds) / Median(seconds[a]);
        ratios[accelerators[a]][kind.name].push_back(ratio);
        const Mistakes mistakes = Judge(kind, answers[a], their_answers, *all);
        std::printf(" (%.2f, wrong %d + %d)", ratio, mistakes.theirs, mistakes.ours);
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  }
  for (const auto& [accelerator, kinds] : ratios)
    for (const auto& [kind, all] : kinds) {
      double sum = 0, least = R3::infinity;
      for (const double r : all) sum += std::log(r), least = std::min(least, r);
      std::printf("%s %-9s geometric mean %.2f, lowest %.2f\n", accelerator.c_str(), kind.c_str(),
                  std::exp(sum / static_cast<double>(all.size())), least);
    }
}
