// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/accuracy_text.h"

#include <fmt/format.h>

#include "luxel/runs/quantity.h"
#include "luxel/runs/refine_text.h"

namespace luxel {
namespace {

// The error of a solver that stops at a requested error, by this measure. in_picture: 0: not known.
std::string error_of_sampled(const SolveReport& solved, double target, ErrorMeasure measure,
                             double in_picture = 0.0) {
  if (solved.stop == StopReason::nothing_to_do) return "none: no light reaches a surface";
  const bool is_seen = measure == ErrorMeasure::seen && solved.seen_error > 0.0;
  const auto error = is_seen ? solved.seen_error : solved.predicted_error;
  if (!is_known_error(error)) return "not yet known: too few rays";
  auto text = fmt::format("{} {}", percent_of(error),
                          is_seen ? "or less from 95 % of viewpoints" : "on average over all surfaces");
  if (is_seen && is_known_error(in_picture))
    text += fmt::format(", {} in the picture", percent_of(in_picture));
  if (target > 0.0) text += fmt::format("; {} requested", percent_of(target));
  return text;
}

// The error of a classical method.
std::string error_of_classical(const SolveReport& solved) {
  std::string text;
  if (solved.error_kind == ErrorKind::noise)
    text = fmt::format("noise {} on average over all surfaces", error_text(solved.predicted_error));
  else if (solved.error_kind == ErrorKind::integration)
    text = fmt::format("form factors are accurate to {}", error_text(solved.predicted_error));
  else
    text = "not known: this method has no estimate of it";
  if (solved.unshot_fraction > 0.0)
    text += fmt::format("; {} of the light is missing", percent_of(solved.unshot_fraction));
  return text;
}

}  // namespace

std::string accuracy_text(const RunReport& report) {
  if (!report.solve) return {};
  const bool is_first_light = report.baked && report.baked->solution.provenance.method == "sampled" &&
                              report.solve->rounds.empty() && report.solve->stop != StopReason::nothing_to_do;
  auto text = is_first_light        ? std::string("not yet known: the run ended at the first light")
              : report.error_target ? error_of_sampled(*report.solve, *report.error_target,
                                                       report.error_measure, report.picture_error)
                                    : error_of_classical(*report.solve);
  if (report.ended_by_ray_budget) text += "; ended by the rays of this --quality (--ray-budget none goes on)";
  if (report.refine && report.baked)
    text += fmt::format("; from the size of patches {}, {} requested",
                        mesh_error_text(*report.refine, report.baked->solution.mesh_error),
                        percent_of(report.mesh_error_target));
  return text;
}

std::string accuracy_text(const Solution& solution) {
  SolveReport solved;
  solved.seen_error = solution.seen_error;
  solved.predicted_error = solution.predicted_error;
  solved.stop = StopReason::error_reached;
  return error_of_sampled(solved, 0.0, ErrorMeasure::seen);
}

std::string stopped_text(const SolveReport& solved, const std::optional<double>& target) {
  const auto by = solved.stop == StopReason::stopped_by_user
                      ? std::string()
                      : fmt::format(" by the {}", description(solved.stop));
  if (target && *target > 0.0)
    return fmt::format("stopped{} before --error {} was reached; writing the light so far", by,
                       as_fraction(*target));
  if (target) return fmt::format("stopped{}; writing the light so far", by);
  return fmt::format("stopped{}: {}; writing the light so far", by,
                     solved.unshot_fraction == 1.0
                         ? std::string("no light had left the lamps yet")
                         : percent_of(solved.unshot_fraction) + " of the light is missing");
}

}  // namespace luxel
