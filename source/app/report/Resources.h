#pragma once

#include <chrono>
#include <cstdint>
#include <utility>

namespace ray {

/// Processor time of all threads of this process so far, in seconds.
double CpuSeconds();
/// The most memory this process ever held, in bytes.
std::int64_t PeakMemory();

/// Memory of this machine, in bytes; the largest number where the system does not say.
std::int64_t MachineMemory();

/// Wall time since it was made, and since it was last asked.
class Stopwatch {
 public:
  double Lap() { return Seconds(std::exchange(lap_, Clock::now())); }
  double Total() const { return Seconds(start_); }

 private:
  using Clock = std::chrono::steady_clock;
  static double Seconds(Clock::time_point since) { return std::chrono::duration<double>(Clock::now() - since).count(); }
  Clock::time_point start_ = Clock::now(), lap_ = start_;
};

}  // namespace ray
