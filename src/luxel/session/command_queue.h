// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

namespace luxel {

// Commands from one thread to another, in order. Every function may be called by any thread.
template <typename Command>
class CommandQueue {
 public:
  // Returns how many commands were pushed so far, this one included.
  std::uint64_t push(Command command) {
    std::unique_lock lock(mutex_);
    commands_.push_back(std::move(command));
    const auto pushed = ++pushed_;
    lock.unlock();
    changed_.notify_all();
    return pushed;
  }
  std::uint64_t pushed() const {
    const std::lock_guard lock(mutex_);
    return pushed_;
  }

  // No more commands are waited for. Those that are waiting can still be taken.
  void close() {
    {
      const std::lock_guard lock(mutex_);
      is_closed_ = true;
    }
    changed_.notify_all();
  }
  bool is_closed() const { return is_closed_; }

  // Returns the commands that are waiting, in order, and removes them. Does not wait.
  std::vector<Command> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(commands_, {});
  }
  // Returns once a command is waiting or the queue is closed.
  void wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return is_closed_ || !commands_.empty(); });
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Command> commands_;
  std::uint64_t pushed_ = 0;
  std::atomic<bool> is_closed_ = false;
};

}  // namespace luxel
