// SPDX-License-Identifier: Apache-2.0
#include "luxel/report/memory.h"

#include <fstream>
#include <string>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace luxel {
namespace {

// The number of kibibytes that a line "key: number kB" of a file under /proc gives.
std::uint64_t kibibytes(const char* file, const std::string& key) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);)
    if (line.rfind(key, 0) == 0) return 1024 * std::stoull(line.substr(key.size()));
  return 0;
}

}  // namespace

std::uint64_t free_memory() { return kibibytes("/proc/meminfo", "MemAvailable:"); }
std::uint64_t resident_memory() { return kibibytes("/proc/self/status", "VmRSS:"); }

void return_freed_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

}  // namespace luxel
