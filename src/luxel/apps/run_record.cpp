// SPDX-License-Identifier: Apache-2.0
#include "luxel/apps/run_record.h"

#include <fmt/format.h>
#include <sys/resource.h>

namespace luxel {

std::uint64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024u;  // Linux counts in KiB
}

std::string RunRecord::table() const {
  double total = 0.0;
  for (const auto& s : stages_) total += s.seconds;
  auto text = fmt::format("{:<12}{:>10}{:>8}{:>16}{:>12}\n", "stage", "seconds", "share", "rays", "ns a ray");
  const auto line = [&](const std::string& name, double seconds, std::uint64_t rays) {
    text +=
        fmt::format("{:<12}{:>10.2f}{:>6.0f} %", name, seconds, total > 0.0 ? 100.0 * seconds / total : 0.0);
    if (rays > 0) text += fmt::format("{:>16}{:>12.0f}", rays, 1e9 * seconds / static_cast<double>(rays));
    text += '\n';
  };
  for (const auto& s : stages_) line(s.name, s.seconds, s.rays);
  line("all", total, 0);
  return text + fmt::format("peak memory {:.0f} MiB", static_cast<double>(peak_memory()) / (1024.0 * 1024.0));
}

}  // namespace luxel
