// How soon an image that is traced beside its viewer answers: medians and 99th percentiles, in milliseconds.
//
//     make bench && build/bench/live [scenes=hello,area_light] [size=512] [threads=N] [times=N]
//
// Columns: from Cancel to the job's end, at a random moment of its passes; from a job's start to a first look that is
// whole, its places chosen by the rate of the job before to take 40 ms. Then the
// seconds of a whole image by a job and by Render with as many threads, taking turns.

#include <tbb/info.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "source/render/FirstLook.h"
#include "source/view/live/RenderJob.h"

namespace {

using Clock = std::chrono::steady_clock;
using ray::RenderJob;

constexpr double first_pass_seconds = 0.04;

double SecondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double Quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(share * last + 0.5)];
}

/// Looks every `pause`, and seldom where looking would slow down what is measured.
template <typename Condition>
void WaitFor(const Condition& holds, std::chrono::microseconds pause = std::chrono::microseconds(50)) {
  while (!holds()) std::this_thread::sleep_for(pause);
}

void PrintTimes(const char* what, const std::vector<double>& seconds) {
  std::printf("  %-34s p50 %8.2f   p99 %8.2f   most %8.2f ms\n", what, 1e3 * Quantile(seconds, 0.5),
              1e3 * Quantile(seconds, 0.99), 1e3 * Quantile(seconds, 1));
}

/// From Cancel to the end of jobs that last at least `seconds`, each canceled at another moment.
std::vector<double> CancelTimes(const std::shared_ptr<const ray::LoadedScene>& scene,
                                const ray::RenderSettings& settings, RenderJob::Order order, double seconds,
                                int times) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> moment(0, seconds);
  std::vector<double> taken;
  while (static_cast<int>(taken.size()) < times) {
    RenderJob job(scene, settings, order);
    std::this_thread::sleep_for(std::chrono::duration<double>(moment(random)));
    if (job.HasEnded()) continue;
    const auto start = Clock::now();
    job.Cancel();
    WaitFor([&] { return job.HasEnded(); });
    taken.push_back(SecondsSince(start));
  }
  return taken;
}

void Measure(const std::string& name, const ray::RenderSettings& settings, int times) {
  const auto scene = std::make_shared<const ray::LoadedScene>("scenes/" + name + ".scn", ray::ParseOptions{},
                                                              ray::AcceleratorSettings{});
  const auto pixels = static_cast<std::int64_t>(settings.width) * settings.height;

  std::vector<double> jobs, rows, renders;
  double rate = 0;
  for (int i = 0; i < 9; ++i) {
    const RenderJob job(scene, settings, RenderJob::Order::coarse_first);
    WaitFor([&] { return job.HasEnded(); }, std::chrono::milliseconds(5));
    jobs.push_back(job.Seconds());
    rate = job.PixelsPerSecond();
    const RenderJob by_rows(scene, settings, RenderJob::Order::rows);
    WaitFor([&] { return by_rows.HasEnded(); }, std::chrono::milliseconds(5));
    rows.push_back(by_rows.Seconds());
    const auto start = Clock::now();
    ray::Render(scene->world, *scene->accelerator, settings);
    renders.push_back(SecondsSince(start));
  }
  const int places = ray::PlacesWithin(first_pass_seconds, pixels, rate);
  const double job_seconds = Quantile(jobs, 0.5), render_seconds = Quantile(renders, 0.5);
  std::printf("%s %dx%d, %d threads, %.3g pixels/s, first look at %d of 64 places\n", name.c_str(), settings.width,
              settings.height, settings.threads, rate, places);

  std::vector<double> first;
  for (int i = 0; i < times; ++i) {
    RenderJob job(scene, settings, RenderJob::Order::coarse_first, ray::PlacesWithin(first_pass_seconds, pixels, rate));
    const auto start = Clock::now();
    WaitFor([&] { return job.Places() > 0; });
    first.push_back(SecondsSince(start));
    rate = job.PixelsPerSecond();
  }
  PrintTimes("start to whole first pass", first);
  PrintTimes("Cancel to end, passes",
             CancelTimes(scene, settings, RenderJob::Order::coarse_first, std::min(1.0, 0.9 * job_seconds), times));
  ray::RenderSettings more = settings;
  more.samples = 16;
  PrintTimes("Cancel to end, 16 samples",
             CancelTimes(scene, more, RenderJob::Order::coarse_first, std::min(1.5, 3 * job_seconds), times));
  PrintTimes("Cancel to end, rows",
             CancelTimes(scene, settings, RenderJob::Order::rows, std::min(1.0, 0.9 * job_seconds), times));
  std::printf("  whole picture: job %.1f ms, rows %.1f ms, Render %.1f ms; speed of the job %.3f, of rows %.3f\n",
              1e3 * job_seconds, 1e3 * Quantile(rows, 0.5), 1e3 * render_seconds, render_seconds / job_seconds,
              render_seconds / Quantile(rows, 0.5));
}

}  // namespace

int main(int argc, char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // lines are seen as they come
  std::map<std::string, std::string> options{
      {"scenes", "hello,area_light"}, {"size", "512"}, {"times", "100"}, {"threads", ""}};
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto equals = word.find('=');
    if (equals == std::string::npos || !options.count(word.substr(0, equals))) {
      std::fprintf(stderr, "live: unknown option %s\n", argv[i]);
      return 1;
    }
    options[word.substr(0, equals)] = word.substr(equals + 1);
  }
  ray::RenderSettings settings;
  settings.width = settings.height = std::stoi(options["size"]);
  settings.threads =
      options["threads"].empty() ? std::max(1, tbb::info::default_concurrency() - 1) : std::stoi(options["threads"]);
  std::istringstream names(options["scenes"]);
  for (std::string name; std::getline(names, name, ',');) Measure(name, settings, std::stoi(options["times"]));
}
