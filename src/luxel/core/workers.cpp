// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/workers.h"

#include <algorithm>
#include <memory>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace luxel {

struct Workers::State {
  explicit State(int threads) : arena(threads) {
    // More threads than cores are allowed (a test asks for seven on two), but TBB needs to be told so. Of
    // several controls alive the lowest holds, so there is none where none is needed.
    if (threads > tbb::info::default_concurrency())
      control = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                      static_cast<std::size_t>(threads));
  }
  std::unique_ptr<tbb::global_control> control;
  mutable tbb::task_arena arena;
};

Workers::Workers(int threads)
    : state_(std::make_unique<State>(threads > 0 ? threads : tbb::info::default_concurrency())) {}

Workers::~Workers() = default;

int Workers::threads() const { return state_->arena.max_concurrency(); }

void Workers::for_chunks(std::size_t count, std::size_t grain,
                         const std::function<void(std::size_t, std::size_t, int)>& body) const {
  if (count == 0) return;
  grain = std::max<std::size_t>(grain, 1);
  const auto chunks = (count + grain - 1) / grain;
  const auto run_chunks = [&](const tbb::blocked_range<std::size_t>& range) {
    for (auto chunk = range.begin(); chunk != range.end(); ++chunk)
      body(chunk * grain, std::min(count, (chunk + 1) * grain), tbb::this_task_arena::current_thread_index());
  };
  // simple_partitioner: the automatic one hands out long runs and answers a stop late.
  state_->arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks, 1), run_chunks, tbb::simple_partitioner());
  });
}

void Workers::run(const std::function<void()>& body) const { state_->arena.execute(body); }

double ordered_sum(const Workers& workers, std::size_t count,
                   const std::function<double(std::size_t)>& term) {
  constexpr std::size_t grain = 4096;
  std::vector<double> sums((count + grain - 1) / grain, 0.0);
  workers.for_chunks(count, grain, [&](std::size_t begin, std::size_t end, int) {
    double sum = 0.0;
    for (auto i = begin; i < end; ++i) sum += term(i);
    sums[begin / grain] = sum;
  });
  double total = 0.0;
  for (const auto sum : sums) total += sum;
  return total;
}

}  // namespace luxel
