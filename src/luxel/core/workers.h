// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace luxel {

// A fixed number of threads that share loops. The home of TBB. Nothing here makes the answer depend on the
// number of threads: the chunks of a loop are the same for one thread and for sixty-four; only who runs them
// differs.
class Workers {
 public:
  // threads: 0 takes every core the process may use.
  explicit Workers(int threads = 0);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int threads() const;

  // Calls body(begin, end, worker) for [0, count) cut at multiples of grain. worker is in [0, threads()); two
  // calls that run at the same time never share one. An exception thrown by a body is rethrown here.
  void for_chunks(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end, int worker)>& body) const;

  // Runs body on these threads, so that a library that uses TBB inside (Embree's builder) keeps to their
  // number.
  void run(const std::function<void()>& body) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Sum over [0, count) of term(i), in double: per fixed chunk, chunks added in order, so the bits do not
// depend on threads.
double ordered_sum(const Workers& workers, std::size_t count, const std::function<double(std::size_t)>& term);

}  // namespace luxel
