// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace luxel {

// The latest of the immutable values that one thread publishes and others read. Every function may be called
// by any thread.
template <typename Value>
class Latest {
 public:
  Latest() : value_(std::make_shared<const Value>()) {}

  // Never null. Before the first publication: a default value.
  std::shared_ptr<const Value> get() const {
    const std::lock_guard lock(mutex_);
    return value_;
  }
  void publish(Value value) {
    auto next = std::make_shared<const Value>(std::move(value));
    const std::lock_guard lock(mutex_);
    value_.swap(next);  // the old value is released after the lock
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const Value> value_;
};

}  // namespace luxel
