// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/context.h"

#include <algorithm>
#include <memory>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "luxel/core/ranks.h"
#include "luxel/core/startable_threads.h"

namespace luxel {

struct Context::Threads {
  // Starts as many of the wanted threads as possible.
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

Context::Context(ContextOptions options)
    : threads_(std::make_shared<const Threads>(options.threads > 0 ? options.threads
                                                                   : tbb::info::default_concurrency())),
      ranks_(options.ranks && options.ranks->size() > 1 ? options.ranks : nullptr),
      log_(std::move(options.log)),
      monitor_(std::move(options.monitor)) {}

int Context::threads() const { return threads_->arena.max_concurrency(); }

Context Context::with_log(LogSink log) const {
  auto context = *this;
  context.log_ = std::move(log);
  return context;
}

Context Context::with_monitor(Monitor monitor) const {
  auto context = *this;
  context.monitor_ = std::move(monitor);
  return context;
}

Context Context::quiet() const {
  auto context = *this;
  context.log_ = {};
  context.monitor_ = {};
  return context;
}

void Context::for_chunks(std::size_t count, std::size_t grain,
                         const std::function<void(std::size_t, std::size_t, int)>& body) const {
  if (count == 0) return;
  grain = std::max<std::size_t>(grain, 1);
  const auto chunks = (count + grain - 1) / grain;
  const auto run_chunks = [&](const tbb::blocked_range<std::size_t>& range) {
    for (auto chunk = range.begin(); chunk != range.end(); ++chunk)
      body(chunk * grain, std::min(count, (chunk + 1) * grain), tbb::this_task_arena::current_thread_index());
  };
  // simple_partitioner: the automatic one hands out long ranges and reacts late to a stop. isolate: a thread
  // that waits for an inner loop starts no other chunk of the outer one.
  threads_->arena.execute([&] {
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks, 1), run_chunks, tbb::simple_partitioner());
    });
  });
}

void Context::run(const std::function<void()>& body) const { threads_->arena.execute(body); }

double ordered_sum(const Context& context, std::size_t count,
                   const std::function<double(std::size_t)>& term) {
  constexpr std::size_t grain = 4096;
  std::vector<double> sums((count + grain - 1) / grain, 0.0);
  context.for_chunks(count, grain, [&](std::size_t begin, std::size_t end, int) {
    double sum = 0.0;
    for (auto i = begin; i < end; ++i) sum += term(i);
    sums[begin / grain] = sum;
  });
  double total = 0.0;
  for (const auto sum : sums) total += sum;
  return total;
}

}  // namespace luxel
