// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "luxel/solution/solution.h"

namespace luxel {

/// One bounce of a shooting method, or one step of Jacobi's iteration.
struct StepRecord {
  std::uint64_t rays = 0;        ///< of the bounce; Jacobi's steps trace none
  double unshot_fraction = 1.0;  ///< after the step
};

/// State of a sampled solve after one doubling.
struct RoundRecord {
  std::uint32_t gather_rays = 0;  ///< per side that light reaches, all replicates together
  std::uint32_t shadow_rays = 0;  ///< per side that light reaches
  std::uint64_t rays = 0;         ///< of the whole run so far
  double seconds = 0.0;           ///< since the solve began
  double answer_seconds = 0.0;    ///< of them, after the samples of the round were taken
  double error = 0.0;             ///< predicted, by the measure that ends the run
  double power_error = 0.0;       ///< area-weighted relative RMS, see Solution::predicted_error
  double uncertainty = 0.0;       ///< of the seen error, relative: jackknife over replicates
  int sweeps = 0;                 ///< of the iteration, for the round's answer
  double residual = 0.0;          ///< estimated distance to the fixed point over the whole radiosity
};

/// Meaning of predicted_error and of the standard errors of a solution.
enum class ErrorKind {
  noise,        ///< of random rays
  integration,  ///< dense: how far the light may be off by the errors of the form factors
  unknown       ///< hemicube: none is stated
};

/// Energy balance of the power of lamps and sky. Arrays are [band], W. emitted + from_sky = absorbed +
/// escaped + lost_at_backs + in_panes + unshot, to rounding (see docs/json.md); shooting assigns each ray to
/// lamps or sky.
struct EnergyBalance {
  std::vector<double> emitted;  ///< by lamps
  /// Power from the sky and from directional lamps onto sides that take part: all fronts, and backs of
  /// two-sided materials. Light that misses the scene, meets an absorbing back directly or is absorbed by
  /// panes of glass on its way is not counted.
  std::vector<double> from_sky;
  std::vector<double> absorbed;       ///< taken up by surfaces that received it
  std::vector<double> escaped;        ///< left the scene
  std::vector<double> lost_at_backs;  ///< met the back of a one-sided material
  std::vector<double> unshot;         ///< not yet propagated when the iteration ended
  /// Light of lamps and surfaces that panes of glass absorb. Empty where the method refuses panes.
  std::vector<double> in_panes = {};
};

/// The irradiance of one side of all patches of a material, in the mean over their area.
struct SurfaceMean {
  std::size_t material = 0;  ///< index into PatchSet::materials
  std::string name;          ///< of the material
  bool is_back = false;
  double area = 0.0;  ///< m², of the sides that light reaches
  /// [band], W/m². The standard error is that of the mean, which does not follow from those of the sides,
  /// because their errors are correlated; widened by student_widening(), so that 1.96 of it contain the true
  /// value on these patches in 95 of 100 cases.
  std::vector<double> irradiance, standard_error;
};

/// The power that all sides receive; a path counts at each surface that it meets.
struct ReceivedPower {
  std::vector<double> power, standard_error;  ///< [band], W; widened as in SurfaceMean
};

struct SurfaceMeans {
  std::vector<SurfaceMean> surfaces;  ///< by material, front before back; those that light reaches
  ReceivedPower received;
};

/// Part of a process in a solve that several share.
struct ProcessRecord {
  std::uint64_t rays = 0;  ///< traced by it; 0 where the method does not count them
  std::uint64_t exchanges = 0;
  std::uint64_t received_bytes = 0;
  double waited_seconds = 0.0;     ///< for other processes and their data
  double processor_seconds = 0.0;  ///< of all its threads, without that of waiting
};

/// Report of a solve. Parts that a method does not have stay empty.
struct SolveReport {
  StopReason stop = StopReason::nothing_to_do;
  ErrorKind error_kind = ErrorKind::noise;
  std::vector<StepRecord> steps;    ///< shooting, and where Jacobi's iteration solves
  std::vector<RoundRecord> rounds;  ///< sampled
  std::uint64_t rays = 0;
  double unshot_fraction = 0.0;    ///< power left over at the end: the stated bias
  double predicted_error = 0.0;    ///< see Solution
  double seen_error = 0.0;         ///< see Solution
  std::size_t views = 0;           ///< that state the seen error
  double places = 0.0;             ///< rooms and the outside, estimated from the views
  double error_uncertainty = 0.0;  ///< of seen_error, relative: jackknife over replicates
  double error_95th = 0.0;         ///< see Solution
  SurfaceMeans means;              ///< sampled: of materials and of the whole, with standard errors
  EnergyBalance energy;
  /// [material], W summed over bands: met the back of that one-sided material
  std::vector<double> back_loss;
  bool streamed = false;     ///< sampled: hits were traced again for every sweep, for want of memory
  std::uint64_t memory = 0;  ///< bytes the process was predicted to hold at its peak; 0: not predicted
  std::uint64_t unreached_sides = 0;  ///< sides that no light reaches, as far as their first rays could tell
  std::uint64_t own_rays = 0;         ///< sampled: traced by this process
  std::vector<ProcessRecord> processes;  ///< that shared the work, in their order; empty: one alone
};

/// Returns the main error of a report: the seen error where it is estimated, else predicted_error.
inline double error_of(const SolveReport& report) {
  return report.seen_error > 0.0 ? report.seen_error : report.predicted_error;
}

}  // namespace luxel
