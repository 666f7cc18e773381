// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace luxel {

// Where the time of a run went.
class RunRecord {
 public:
  struct Stage {
    std::string name;
    double seconds = 0.0;
    std::uint64_t rays = 0;
  };

  // Runs body and books its time. body may set its rays.
  template <typename Body>
  auto stage(std::string name, Body body) {
    const Timer timer(*this, std::move(name));
    return body(stages_[timer.index]);
  }

  const std::vector<Stage>& stages() const { return stages_; }
  // Stage, time, share, rays, time a ray; total and peak memory.
  std::string table() const;

 private:
  struct Timer {
    Timer(RunRecord& run, std::string name)
        : record(run), index(run.stages_.size()), begin(std::chrono::steady_clock::now()) {
      record.stages_.push_back({std::move(name)});
    }
    ~Timer() {
      record.stages_[index].seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    RunRecord& record;
    std::size_t index;
    std::chrono::steady_clock::time_point begin;
  };
  std::vector<Stage> stages_;
};

// The most memory this process has held so far, bytes.
std::uint64_t peak_memory();

}  // namespace luxel
