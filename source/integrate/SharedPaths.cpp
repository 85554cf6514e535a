#include "source/integrate/SharedPaths.h"

#include <algorithm>

namespace ray {

void SharedPaths::Begin(std::size_t samples, const RandomKey& key) {
  firsts_.clear(), seconds_.clear(), taken_ = 0;
  firsts_.reserve(samples), seconds_.reserve(samples);
  const auto count = static_cast<std::uint32_t>(samples), groups = std::max(1u, count / group_size);
  const Shuffle shuffle(count, key);
  group_of_.resize(samples);
  for (std::uint32_t i = 0; i < count; ++i) group_of_[i] = shuffle(i) % groups;
}

std::uint32_t SharedPaths::AddFirst(const ShadingPoint& x, std::size_t sample) {
  firsts_.push_back({x, static_cast<std::uint32_t>(sample)});
  return static_cast<std::uint32_t>(firsts_.size() - 1);
}

void SharedPaths::AddSecond(const ShadingPoint& y, std::uint32_t first, std::uint32_t path, double throughput,
                            const R2::Color& own) {
  seconds_.push_back({y.free_point, y.Outward(), first, path, throughput, own, {}});
}

void SharedPaths::TakeLight(std::span<R2::Color> gathered) {
  for (; taken_ < seconds_.size(); ++taken_) {
    Second& second = seconds_[taken_];
    second.sent = gathered[second.path] / second.throughput;
    gathered[second.path] = second.own;
  }
}

void SharedPaths::GiveBack(std::span<R2::Color> radiances) const {
  for (const Second& second : seconds_) {
    const First& first = firsts_[second.first];
    radiances[first.sample] += first.x.path.throughput * first.x.kd * second.sent;
  }
}

std::vector<SharedPaths::Group> SharedPaths::Groups() const {
  std::vector<Group> groups(group_of_.empty() ? 0 : *std::ranges::max_element(group_of_) + 1);
  for (std::uint32_t i = 0; i < firsts_.size(); ++i) groups[group_of_[firsts_[i].sample]].firsts.push_back(i);
  for (std::uint32_t j = 0; j < seconds_.size(); ++j)
    if (!IsBlack(seconds_[j].sent)) groups[group_of_[firsts_[seconds_[j].first].sample]].seconds.push_back(j);
  return groups;
}

void SharedPaths::FindDensities(const Group& group, const Tracer& tracer, std::vector<double>& q,
                                TraceState& state) const {
  constexpr R2::Color reaching{1, 1, 1};
  constexpr double least = 1e-300;  // a path that has reached its own second surface by rounding alone
  state.arrived.assign(group.seconds.size() * group.firsts.size(), {});
  q.clear();
  for (const std::uint32_t j : group.seconds) {
    const Second& second = seconds_[j];
    // A common unit of length cancels out. This one keeps fourth powers from overflowing.
    const double unit = Length(second.y - firsts_[second.first].x.free_point);
    for (const std::uint32_t m : group.firsts) {
      const ShadingPoint& x = firsts_[m].x;
      const R3::Vector to_y = second.y - x.free_point, w = to_y / unit;
      const double square = Dot(w, w), at_x = Dot(x.N, w), at_y = -Dot(second.normal, w);
      const double density = at_x > 0 && at_y > 0 ? at_x / square * (at_y / square) : 0;
      const std::size_t pair = q.size();
      q.push_back(m == second.first ? std::max(density, least) : density);
      if (m == second.first)
        state.arrived[pair] = reaching;
      else if (density > 0)
        tracer.AddShadowRay(
            x, pair, {.to_light = to_y}, reaching, reaching, [] { return "a shared path"; }, state);
    }
  }
  tracer.TraceShadowRays(state);
  for (std::size_t pair = 0; pair < q.size(); ++pair) q[pair] *= state.arrived[pair].r;
}

void SharedPaths::Distribute(const Tracer& tracer, std::span<R2::Color> radiances, TraceState& state) const {
  std::vector<double> q;
  for (const Group& group : Groups()) {
    FindDensities(group, tracer, q, state);
    auto of_second = q.begin();
    for (const std::uint32_t j : group.seconds) {
      double sum = 0;
      for (std::size_t m = 0; m < group.firsts.size(); ++m) sum += of_second[static_cast<std::ptrdiff_t>(m)];
      for (const std::uint32_t m : group.firsts) {
        const ShadingPoint& x = firsts_[m].x;
        const double share = *of_second++ / sum;
        if (share > 0) radiances[firsts_[m].sample] += share * (x.path.throughput * x.kd * seconds_[j].sent);
      }
    }
  }
}

}  // namespace ray
