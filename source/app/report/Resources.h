#pragma once

#include <chrono>
#include <cstdint>
#include <utility>

namespace ray {

/// Returns the processor time of all threads of this process so far, in seconds.
double CpuSeconds();
/// Returns the peak memory of this process, in bytes.
std::int64_t PeakMemory();

/// Returns the memory of this machine, in bytes; the largest number if the system does not report it.
std::int64_t MachineMemory();

/// Measures wall time since construction, and since the last query.
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
