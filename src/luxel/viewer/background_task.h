// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <future>
#include <optional>
#include <utility>

namespace luxel {

// One task at a time in a thread of its own, whose result is polled between frames. The destructor waits for
// the task.
template <typename Result>
class BackgroundTask {
 public:
  // Starts a task, which must own its data. Only while no task is running.
  template <typename Work>
  void start(Work work) {
    future_ = std::async(std::launch::async, std::move(work));
  }
  bool is_busy() const { return future_.valid(); }
  bool is_ready() const {
    return future_.valid() && future_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }
  void wait() const {
    if (future_.valid()) future_.wait();
  }
  // Waits up to this many seconds.
  void wait(double seconds) const {
    if (future_.valid()) future_.wait_for(std::chrono::duration<double>(seconds));
  }
  // The result, once. Throws what the work threw.
  std::optional<Result> take() {
    if (!is_ready()) return std::nullopt;
    return future_.get();
  }

 private:
  std::future<Result> future_;
};

}  // namespace luxel
