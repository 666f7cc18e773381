// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/memory.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <sys/resource.h>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace luxel {
namespace {

namespace fs = std::filesystem;

std::optional<std::uint64_t> number_in(std::string_view text) {
  const auto begin = std::min(text.size(), text.find_first_not_of(" \t"));
  std::uint64_t number = 0;
  const auto read = std::from_chars(text.data() + begin, text.data() + text.size(), number);
  return read.ec == std::errc() ? std::optional(number) : std::nullopt;
}

// Returns the number after a key at the beginning of a line; without a key, the number at the beginning of
// the file.
std::optional<std::uint64_t> number_after(const fs::path& file, std::string_view key = {}) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(key)) return number_in(std::string_view(line).substr(key.size()));
  return {};
}

std::uint64_t kibibytes(const fs::path& file, std::string_view key) {
  return 1024 * number_after(file, key).value_or(0);
}

// words: separated by commas.
bool has_word(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const auto end = std::min(words.size(), words.find(','));
    if (words.substr(0, end) == word) return true;
    words.remove_prefix(std::min(words.size(), end + 1));
  }
  return false;
}

constexpr auto no_limit = std::numeric_limits<std::uint64_t>::max();

std::uint64_t left_of(std::optional<std::uint64_t> limit, std::uint64_t used) {
  if (!limit) return no_limit;
  return *limit > used ? *limit - used : 1;
}

// File names of one version of control groups.
struct ControlFiles {
  const char* folder;
  const char* limit;
  const char* used;
  std::string_view cache;  // key in memory.stat: file cache that the system can reclaim
};
constexpr ControlFiles first_version = {"sys/fs/cgroup/memory", "memory.limit_in_bytes",
                                        "memory.usage_in_bytes", "total_inactive_file "};
constexpr ControlFiles second_version = {"sys/fs/cgroup", "memory.max", "memory.current", "inactive_file "};

// Returns the memory left by the limits of the process's control groups and their parents.
std::uint64_t left_by_control_groups(const fs::path& root) {
  auto left = no_limit;
  std::ifstream lines(root / "proc/self/cgroup");
  for (std::string line; std::getline(lines, line);) {  // number:controllers:/path
    const auto first = line.find(':');
    const auto second = line.find(':', first + 1);
    if (second == std::string::npos) continue;
    const auto controllers = std::string_view(line).substr(first + 1, second - first - 1);
    const bool is_second = controllers.empty();
    if (!is_second && !has_word(controllers, "memory")) continue;
    const auto& files = is_second ? second_version : first_version;
    // Inside a container the path may be the one of the host; then the topmost folder is the container's own.
    for (auto path = fs::path(line.substr(second + 1)).relative_path();; path = path.parent_path()) {
      const auto folder = root / files.folder / path;
      const auto used = number_after(folder / files.used).value_or(0);
      const auto cache = number_after(folder / "memory.stat", files.cache).value_or(0);
      left = std::min(left, left_of(number_after(folder / files.limit), used - std::min(used, cache)));
      if (path.empty()) break;
    }
  }
  return left;
}

std::uint64_t left_by_address_space(const fs::path& root) {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return no_limit;
  return left_of(limit.rlim_cur, kibibytes(root / "proc/self/status", "VmSize:"));
}

}  // namespace

std::uint64_t free_memory(const fs::path& root) {
  const auto free = kibibytes(root / "proc/meminfo", "MemAvailable:");
  return std::min({free, left_by_control_groups(root), left_by_address_space(root)});
}

std::string lack_of_memory(double needed) {
  const auto free = static_cast<double>(free_memory());
  if (free == 0.0 || needed <= free) return {};
  return fmt::format("{:.0f} MB of memory, of which {:.0f} are free", 1e-6 * needed, 1e-6 * free);
}

std::uint64_t resident_memory() { return kibibytes("/proc/self/status", "VmRSS:"); }

void return_freed_memory() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

}  // namespace luxel
