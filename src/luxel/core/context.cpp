// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/context.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "luxel/core/ranks.h"
#include "luxel/core/thread_pool.h"

namespace luxel {

Context::Context(ContextOptions options)
    : threads_(std::make_shared<const ThreadPool>(options.threads)),
      ranks_(options.ranks && options.ranks->size() > 1 ? options.ranks : nullptr),
      log_(std::move(options.log)),
      monitor_(std::move(options.monitor)) {}

int Context::threads() const { return threads_->size(); }

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
  threads_->for_each(chunks, [&](std::size_t chunk, int thread) {
    body(chunk * grain, std::min(count, (chunk + 1) * grain), thread);
  });
}

void Context::run(const std::function<void()>& body) const { threads_->run(body); }

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
