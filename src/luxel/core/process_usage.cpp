// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/process_usage.h"

#include <ctime>
#include <fstream>
#include <limits>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <sys/resource.h>
#include <unistd.h>

namespace luxel {
namespace {

double seconds_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

double processor_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }
double processor_seconds_of_thread() { return seconds_of(CLOCK_THREAD_CPUTIME_ID); }

double process_age() {
  std::ifstream file("/proc/self/stat");
  std::string text;
  std::getline(file, text);
  // The 22nd field (proc(5), starttime); the second is a name in brackets that may contain anything.
  auto at = text.rfind(')');
  for (int field = 3; at != std::string::npos && field <= 22; ++field) at = text.find(' ', at + 1);
  timespec now{};
  if (at == std::string::npos || clock_gettime(CLOCK_BOOTTIME, &now) != 0) return 0.0;
  const auto start =
      static_cast<double>(std::stoull(text.substr(at))) / static_cast<double>(sysconf(_SC_CLK_TCK));
  const auto age = static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) - start;
  return age > 0.0 ? age : 0.0;
}

std::uint64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024u;  // Linux counts in KiB
}

void keep_freed_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

}  // namespace luxel
