// SPDX-License-Identifier: Apache-2.0
// The pool of threads in builds with the thread sanitizer: see thread_pool.h.
#ifdef LUXEL_PLAIN_THREADS

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <tbb/global_control.h>

#include "luxel/core/startable_threads.h"
#include "luxel/core/thread_pool.h"

namespace luxel {
namespace {

constexpr int outside = -1;
thread_local int own_index = outside;  // in the loop that this thread runs

// One loop: its threads take the next index until none is left, or one has thrown.
class Loop {
 public:
  Loop(std::size_t count, const std::function<void(std::size_t, int)>& body) : count_(count), body_(body) {}

  void work(int thread) {
    own_index = thread;
    try {
      for (auto i = next_++; i < count_; i = next_++) body_(i, thread);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
      next_ = count_;
    }
    own_index = outside;
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::size_t count_;
  const std::function<void(std::size_t, int)>& body_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

}  // namespace

struct ThreadPool::Threads {
  int size;
};

ThreadPool::ThreadPool(int wanted)
    : threads_(std::make_unique<const Threads>(Threads{startable_threads(
          wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency())))})) {}
ThreadPool::~ThreadPool() = default;

int ThreadPool::size() const { return threads_->size; }

// Starts threads for each loop; inner loops run on the thread that calls them.
void ThreadPool::for_each(std::size_t count, const std::function<void(std::size_t, int)>& body) const {
  if (own_index != outside) {
    for (std::size_t i = 0; i < count; ++i) body(i, own_index);
    return;
  }
  Loop loop(count, body);
  std::vector<std::thread> others;
  const auto threads = std::min(static_cast<std::size_t>(size()), count);
  for (std::size_t i = 1; i < threads; ++i)
    others.emplace_back([&loop, i] { loop.work(static_cast<int>(i)); });
  loop.work(0);
  for (auto& thread : others) thread.join();
  loop.rethrow();
}

// Without threads of TBB in it, of which the sanitizer sees no synchronisation.
void ThreadPool::run(const std::function<void()>& body) const {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  body();
}

}  // namespace luxel

#endif
