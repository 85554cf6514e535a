#include "source/app/report/Resources.h"

#include <sys/resource.h>
#include <unistd.h>

#include <fstream>
#include <limits>
#include <string>

namespace ray {
namespace {

rusage Usage() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return usage;
}

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Returns Linux's peak memory from /proc, 0 on other systems. The peak of getrusage also counts the process that
/// started this one, before it became this program.
std::int64_t PeakOfProcFile() {
  std::ifstream status("/proc/self/status");
  std::int64_t kibibytes = 0;
  for (std::string word; status >> word;)
    if (word == "VmHWM:" && status >> kibibytes) return 1024 * kibibytes;
  return 0;
}

}  // namespace

double CpuSeconds() {
  const rusage usage = Usage();
  return Seconds(usage.ru_utime) + Seconds(usage.ru_stime);
}

std::int64_t PeakMemory() {
  if (const std::int64_t peak = PeakOfProcFile(); peak > 0) return peak;
#ifdef __APPLE__
  constexpr std::int64_t unit = 1;
#else
  constexpr std::int64_t unit = 1024;
#endif
  return unit * Usage().ru_maxrss;
}

std::int64_t MachineMemory() {
  const std::int64_t pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
  return pages > 0 && page > 0 ? pages * page : std::numeric_limits<std::int64_t>::max();
}

}  // namespace ray
