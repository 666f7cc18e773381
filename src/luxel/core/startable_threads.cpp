// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/startable_threads.h"

#include <algorithm>
#include <latch>
#include <limits>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace luxel {
namespace {

// Starts up to `count` threads that all run at the same time; returns how many could be started.
int start_together(int count) {
  std::vector<std::thread> threads;
  threads.reserve(static_cast<std::size_t>(count));
  std::latch end(1);
  try {
    for (int i = 0; i < count; ++i) threads.emplace_back([&end] { end.wait(); });
  } catch (const std::system_error&) {
  } catch (const std::bad_alloc&) {
  }
  end.count_down();
  for (auto& thread : threads) thread.join();
  return static_cast<int>(threads.size());
}

struct Known {
  std::mutex mutex;
  int started = 1;
  int most = std::numeric_limits<int>::max();
};

}  // namespace

int startable_threads(int wanted) {
  static Known known;
  const std::lock_guard lock(known.mutex);
  wanted = std::clamp(wanted, 1, known.most);
  if (wanted <= known.started) return wanted;
  known.started = 1 + start_together(wanted - 1);
  if (known.started < wanted) known.most = known.started;
  return known.started;
}

}  // namespace luxel
