// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace luxel {

// Times and rays of the stages of a run. Times count from the start of the process, unless an age is given.
class RunRecord {
 public:
  RunRecord();
  // Times count from now less `age` seconds, for a run that is a part of a longer process.
  explicit RunRecord(double age);

  struct Stage {
    std::string name;
    double begin = 0.0;    // s
    double seconds = 0.0;  // it took
    std::uint64_t rays = 0;
  };

  // Runs body and records its time. body may set the rays of its stage.
  template <typename Body>
  auto stage(std::string name, Body body) {
    const Timer timer(*this, std::move(name));
    return body(stages_[timer.index]);
  }

  // Records the time of the first call: the first picture of the whole scene is there.
  void note_light();

  const std::vector<Stage>& stages() const { return stages_; }
  // Time of the first picture of the whole scene, s; nothing where there was none.
  std::optional<double> first_light() const { return first_light_; }
  // The same, counted from the end of the stage "load".
  std::optional<double> first_light_after_load() const;
  // Seconds since the process started.
  double elapsed() const { return now(); }
  // Rays of all stages.
  std::uint64_t rays() const;
  // "4.1 s, 12.4 million rays, 183 MiB of memory".
  std::string summary() const;
  // A table of the stages, with time, fraction of the whole, rays and time per ray, and the time of the first
  // light.
  std::string table() const;

 private:
  struct Timer {
    Timer(RunRecord& run, std::string name) : record(run), index(run.stages_.size()) {
      record.stages_.push_back({std::move(name), record.now()});
    }
    ~Timer() { record.stages_[index].seconds = record.now() - record.stages_[index].begin; }
    RunRecord& record;
    std::size_t index;
  };
  double now() const;  // s

  std::chrono::steady_clock::time_point made_;
  double age_when_made_;  // of the process, s
  std::vector<Stage> stages_;
  std::optional<double> first_light_;
};

}  // namespace luxel
