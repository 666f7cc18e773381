// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace luxel {

// A fixed number of threads that run loops. Any number of threads may call it at the same time.
//
// TBB runs the loops. With the thread sanitizer, plain threads do: Debian builds TBB without it, so that the
// sanitizer sees none of the synchronisation in TBB, and would report every loop as a race.
class ThreadPool {
 public:
  // wanted: the calling thread included; 0: as many as there are processors. See startable_threads().
  explicit ThreadPool(int wanted);
  ~ThreadPool();

  int size() const;

  // Calls body(index, thread) for each index in [0, count), in any order, on up to size() threads, and
  // returns when all have returned. thread: in [0, size()), different for calls of one loop that run at the
  // same time. Loops may be nested; a thread that waits for an inner loop begins no other call of the outer
  // one.
  void for_each(std::size_t count, const std::function<void(std::size_t, int)>& body) const;

  // Calls body once; libraries that use TBB inside it use this many threads.
  void run(const std::function<void()>& body) const;

 private:
  struct Threads;
  std::unique_ptr<const Threads> threads_;
};

}  // namespace luxel
