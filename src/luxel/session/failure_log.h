// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>

namespace luxel {

// Failures in the threads of a session. Every function may be called by any thread.
class FailureLog {
 public:
  struct Last {
    std::string message;      // one sentence; empty: nothing has failed
    std::uint64_t count = 0;  // of failures so far
  };

  // Does the work, and records what it throws. Returns whether it succeeded. file: of the scene.
  bool attempt(const std::filesystem::path& file, const std::function<void()>& work);
  Last last() const;

 private:
  bool record(std::string message);

  mutable std::mutex mutex_;
  Last last_;
};

}  // namespace luxel
