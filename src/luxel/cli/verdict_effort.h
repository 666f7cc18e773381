// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "luxel/lighting/verdict.h"
#include "luxel/render/probe_light.h"

namespace luxel {

// The solution that a measurement comes from.
struct MeasuredSolution {
  std::string file;
  double seen_error = 0.0;  // 0: not estimated
  bool can_resume = false;  // whether the solution can be refined further
};

// The further effort that would settle the open verdicts of a measurement.
class VerdictEffort {
 public:
  // floor: lx, see ProbeOptions.
  explicit VerdictEffort(const ProbeOptions& options) : error_(options.error), floor_(options.floor) {}

  // Verdicts on the points of one area.
  void add(const std::vector<Verdict>& verdicts, const std::vector<ProbedLight>& light);
  // A verdict that no rays to points decide: counts what it needs of the solution.
  void add(const Verdict& verdict);
  // Sentences with the --error that would decide open verdicts, and the longer time it takes; empty where
  // none is open. seconds: that the measurement took; 0: not known.
  std::vector<std::string> sentences(const MeasuredSolution& solution, double seconds) const;

 private:
  double error_, floor_;
  double rays_ = 1.0, factor_ = 1.0;
};

}  // namespace luxel
