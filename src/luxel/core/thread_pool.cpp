// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/thread_pool.h"

#ifndef LUXEL_PLAIN_THREADS

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "luxel/core/startable_threads.h"

namespace luxel {

struct ThreadPool::Threads {
  explicit Threads(int wanted) : arena(startable_threads(wanted)) {
    const auto most = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    const auto started = static_cast<std::size_t>(arena.max_concurrency());
    // More threads than cores are allowed (a test uses seven on two), but TBB must be configured for it. The
    // lowest of several live controls applies, so none is created where none is needed: here, and where TBB
    // would start threads of its own that cannot be started.
    if (started > most || arena.max_concurrency() < wanted)
      control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism, started);
  }
  std::unique_ptr<tbb::global_control> control;
  mutable tbb::task_arena arena;
};

ThreadPool::ThreadPool(int wanted)
    : threads_(std::make_unique<const Threads>(wanted > 0 ? wanted : tbb::info::default_concurrency())) {}
ThreadPool::~ThreadPool() = default;

int ThreadPool::size() const { return threads_->arena.max_concurrency(); }

void ThreadPool::for_each(std::size_t count, const std::function<void(std::size_t, int)>& body) const {
  const auto run_range = [&](const tbb::blocked_range<std::size_t>& range) {
    for (auto i = range.begin(); i != range.end(); ++i) body(i, tbb::this_task_arena::current_thread_index());
  };
  // simple_partitioner: the automatic one hands out long ranges and reacts late to a stop. isolate: a thread
  // that waits for an inner loop starts no other chunk of the outer one.
  threads_->arena.execute([&] {
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 1), run_range, tbb::simple_partitioner());
    });
  });
}

void ThreadPool::run(const std::function<void()>& body) const { threads_->arena.execute(body); }

}  // namespace luxel

#endif
