#pragma once

#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "R2/ImageFile.h"
#include "R2/compare/Difference.h"
#include "bench/TradeScenes.h"
#include "source/render/Render.h"
#include "tests/Named.h"

/// Rendering and measuring for the goals of the trade of time for accuracy.
namespace trade {

/// What the command line says.
struct Wishes {
  bool quick = false;  // a few seeds and settings: to see that all works, not to decide
  int seeds = 0;       // 0: what each goal needs
  std::string scenes;  // with commas between; empty: those of each goal. Only goals that judge scenes alike look at it
  std::filesystem::path out, raypro;  // `out` empty: nothing is written
};

/// Where a figure is to lie.
struct Limits {
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
};
inline Limits AtMost(double most) { return {.most = most}; }
inline Limits AtLeast(double least) { return {.least = least}; }

/// The CPU time of the process so far.
inline double CpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double Mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

/// The standard error of the mean of independent values.
inline double StandardError(const std::vector<double>& values) {
  const double mean = Mean(values), n = static_cast<double>(values.size());
  double sum = 0;
  for (const double v : values) sum += (v - mean) * (v - mean);
  return n > 1 ? std::sqrt(sum / (n - 1) / n) : std::numeric_limits<double>::infinity();
}

inline double Quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}
inline double Median(std::vector<double> values) { return Quantile(std::move(values), 0.5); }

/// From the mean of squared errors, which may be below 0 where two references cancel their noise.
inline double Root(double mean_square) { return std::sqrt(std::max(0.0, mean_square)); }

/// A subject built, and its references.
struct Site {
  explicit Site(Subject s) : subject(std::move(s)), world(subject.scene) {
    ray::AcceleratorSettings how;
    how.expected_rays = 1e8;
    accelerator = ray::FindAcceleratorKind(how.name)->Make(world, how);
  }

  Subject subject;
  ray::World world;
  std::unique_ptr<const ray::Accelerator> accelerator;
};

using References = std::array<R2::Image, 2>;

struct Shot {
  ray::RenderResult result;
  double cpu_seconds = 0;
};

inline void SetSamples(ray::RenderSettings& settings, const Subject& subject, int samples) {
  (subject.counts_shadow_rays ? settings.trace.shadow_samples : settings.samples) = samples;
}

/// Everything that goals share: subjects, references, and what was rendered for another goal already.
class Lab {
 public:
  explicit Lab(Wishes wishes) : wishes_(std::move(wishes)) {
    if (!wishes_.out.empty()) std::filesystem::create_directories(wishes_.out);
  }

  const Wishes& wishes() const { return wishes_; }
  /// `usual`, less when in a hurry, or what was asked for.
  int Seeds(int usual) const {
    if (wishes_.seeds > 0) return wishes_.seeds;
    return wishes_.quick ? std::max(2, usual / 4) : usual;
  }

  /// The scenes among `all` that were asked for; the first ones when in a hurry.
  std::vector<std::string> Scenes(std::vector<std::string> all) const {
    if (!wishes_.scenes.empty())
      std::erase_if(all, [&](const std::string& name) {
        return ("," + wishes_.scenes + ",").find("," + name + ",") == std::string::npos;
      });
    else if (wishes_.quick)
      all.resize(std::min<std::size_t>(all.size(), 2));
    return all;
  }

  const Site& At(const std::string& name) {
    auto& site = sites_[name];
    if (!site) site = std::make_unique<Site>(MakeSubject(name));
    return *site;
  }

  static Shot Take(const Site& site, const ray::RenderSettings& settings) {
    const double before = CpuSeconds();
    Shot shot{Render(site.world, *site.accelerator, settings), 0};
    shot.cpu_seconds = CpuSeconds() - before;
    return shot;
  }

  /// Two pictures of the subject with independent noise, less of it than in what is measured. GpuCache in files
  /// between runs: delete them when the renderer has changed. Many lights are all asked, not chosen among.
  const References& ReferencesOf(const std::string& name, const std::string& filter = "box") {
    auto& pair = references_[name + "-" + filter];
    if (pair) return *pair;
    pair = std::make_unique<References>();
    const Site& site = At(name);
    for (std::uint64_t i = 0; i < 2; ++i) {
      ray::RenderSettings settings = site.subject.settings;
      const auto lights = static_cast<int>(site.subject.scene.lights.size());
      const int samples = wishes_.quick ? 512 : 1024;
      SetSamples(settings, site.subject, settings.trace.lights > 0 ? std::max(8, 2 * samples / lights) : samples);
      settings.filter = project::Named{filter};
      settings.seed = 900'001 + i;
      if (settings.trace.lights > 0) settings.trace.lights = 0;
      const std::filesystem::path file =
          wishes_.out / ("reference-" + name + "-" + filter + "-" +
                         std::to_string(std::max(settings.samples, settings.trace.shadow_samples)) + "-" +
                         std::to_string(i) + ".pfm");
      (*pair)[i] = GpuCache(file, [&] { return Take(site, settings).result.image; });
    }
    return *pair;
  }

  double SquaredError(const std::string& name, const R2::Image& picture, const std::string& filter = "box") {
    const References& r = ReferencesOf(name, filter);
    return R2::ProductMse(picture, r[0], r[1]);
  }

  /// Squared errors of the subject with a sampler and a number of samples, one a seed. Seeds are others for each number
  /// of samples, so that errors at two of them are independent.
  const std::vector<double>& SquaredErrors(const std::string& name, const std::string& sampler, int samples, int seeds,
                                           const std::string& filter = "box") {
    auto& errors = errors_[name + " " + sampler + " " + filter + " " + std::to_string(samples)];
    while (static_cast<int>(errors.size()) < seeds) {
      ray::RenderSettings settings = At(name).subject.settings;
      settings.trace.sampler = project::Named{sampler};
      settings.filter = project::Named{filter};
      settings.seed = static_cast<std::uint64_t>(1000 * samples) + errors.size();
      SetSamples(settings, At(name).subject, samples);
      errors.push_back(SquaredError(name, Take(At(name), settings).result.image, filter));
    }
    return errors;
  }

  static R2::Image ReadImage(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    return R2::DecodeImage({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}).image;
  }

 private:
  template <typename Make>
  R2::Image GpuCache(const std::filesystem::path& file, const Make& make) const {
    if (wishes_.out.empty()) return make();
    if (std::filesystem::exists(file)) return ReadImage(file);
    const R2::Image image = make();
    const auto bytes = R2::FormatForName(file.string())->encode(image, {}, {});
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return image;
  }

  Wishes wishes_;
  std::map<std::string, std::unique_ptr<Site>> sites_;
  std::map<std::string, std::unique_ptr<References>> references_;
  std::map<std::string, std::vector<double>> errors_;
};

/// Figures of one goal, printed as they come and written as trade-<letter>.csv. A figure that is not finite is missed.
class Table {
 public:
  Table(const Lab& lab, char letter, const std::string& title) : letter_(letter), out_(lab.wishes().out) {
    std::printf("\n%c. %s\n", letter, title.c_str());
    if (out_.empty()) return;
    csv_.open(out_ / (std::string("trade-") + letter + ".csv"));
    csv_ << "goal,what,figure,least,most,verdict\n";
  }

  /// Something to know, no goal.
  void PrintError(const std::string& what, double figure) { Row(what, figure, {}, "", ""); }
  void Add(const std::string& what, double figure, const Limits& limits) {
    const bool is_met = figure >= limits.least && figure <= limits.most;
    missed_ += !is_met;
    ++goals_;
    std::string goal;
    if (std::isfinite(limits.least) && std::isfinite(limits.most))
      goal = Line("%g .. %g", limits.least, limits.most);
    else
      goal = std::isfinite(limits.least) ? Line(">= %g", limits.least) : Line("<= %g", limits.most);
    Row(what, figure, limits, goal, is_met ? "met" : "missed");
  }
  /// A second file beside, trade-<letter>-renders.csv, for what the figures are made from; writes nowhere without a
  /// folder.
  std::ofstream Rows(const char* head) const {
    std::ofstream rows;
    if (!out_.empty()) rows.open(out_ / (std::string("trade-") + letter_ + "-renders.csv"));
    rows << head << '\n';
    return rows;
  }
  int Missed() const { return missed_; }
  int Goals() const { return goals_; }

 private:
  void Row(const std::string& what, double figure, const Limits& limits, const std::string& goal, const char* verdict) {
    std::printf("   %-64s %10.4g   %-16s %s\n", what.c_str(), figure, goal.c_str(), verdict);
    std::fflush(stdout);
    if (!csv_.is_open()) return;
    const auto number = [](double x) { return std::isfinite(x) ? Line("%.6g", x) : std::string(); };
    csv_ << letter_ << ",\"" << what << "\"," << number(figure) << ',' << number(limits.least) << ','
         << number(limits.most) << ',' << verdict << '\n'
         << std::flush;
  }

  char letter_;
  std::filesystem::path out_;
  std::ofstream csv_;
  int missed_ = 0, goals_ = 0;
};

}  // namespace trade
