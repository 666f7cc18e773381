// SPDX-License-Identifier: Apache-2.0
#include "luxel/classical/classical.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "luxel/classical/dense_operator.h"
#include "luxel/classical/direct_solve.h"
#include "luxel/classical/gauss_seidel.h"
#include "luxel/classical/hemicube_operator.h"
#include "luxel/classical/jacobi.h"
#include "luxel/classical/line_errors.h"
#include "luxel/classical/row_light.h"
#include "luxel/classical/stochastic_jacobi.h"
#include "luxel/patch/check_light.h"

namespace luxel {
namespace {

constexpr double rounding = 1e-6;  // relative to the light: factors and radiosities are stored as floats

// One run of any of the three methods; updates light, solution and report together.
class ClassicalRun {
 public:
  ClassicalRun(const PatchSet& patches, Solution& solution, const char* method, const LightSink& on_light,
               const Context& context)
      : patches_(patches), solution_(solution), on_light_(on_light), context_(context) {
    check_light(patches);
    check_even_sky(patches);
    const auto before = std::exchange(solution_, {});
    solution_.mesh_error = before.mesh_error;  // this and the three below are set by the caller
    solution_.provenance.program_version = before.provenance.program_version;
    solution_.provenance.command_line = before.provenance.command_line;
    solution_.provenance.options = before.provenance.options;
    solution_.bands = patches.bands;
    solution_.provenance.method = method;
    solution_.provenance.scene_fingerprint = patches.scene_fingerprint;
  }

  // The run was stopped before there was an operator: only the lamps emit.
  SolveReport stopped_in_the_dark() {
    const auto count = patches_.size() * patches_.band_count();
    for (auto* array : {&solution_.irradiance.front, &solution_.irradiance.back, &solution_.radiosity.front,
                        &solution_.radiosity.back})
      array->assign(count, 0.0f);
    for (std::size_t i = 0; i < count; ++i)
      solution_.radiosity.front[i] = patches_.emittance(i / patches_.band_count(), i % patches_.band_count());
    auto& energy = report_.energy;
    energy.emitted = energy.unshot = emitted_power(patches_);
    for (auto* part :
         {&energy.from_sky, &energy.absorbed, &energy.escaped, &energy.lost_at_backs, &energy.in_panes})
      part->assign(patches_.band_count(), 0.0);
    report_.back_loss.assign(patches_.materials.size(), 0.0);
    report_.unshot_fraction = 1.0;
    return sign(StopReason::stopped_by_user);
  }

  StopReason iterate(const RowOperator& transport, RowLight& light, const JacobiOptions& options) {
    const auto show = [&](const JacobiStep& step) {
      report_.steps.push_back({0, step.unshot_fraction});
      report_.unshot_fraction = step.unshot_fraction;
      show_light(transport, light);
    };
    report_.unshot_fraction = 1.0;
    const auto end = jacobi(transport,
                            {light.area, light.emittance, light.from_sky, light.scattering, light.before,
                             light.irradiance, light.radiosity},
                            options, context_, show)
                         .end;
    if (end == JacobiEnd::stopped) return StopReason::stopped_by_user;
    return end == JacobiEnd::step_limit ? StopReason::step_limit : StopReason::converged;
  }

  // R = S (D + F E + F R) with the scattering S, and then B = E + R.
  StopReason iterate_by_parts(const RowOperator& transport, RowLight& light, double tolerance) {
    std::vector<float> direct(light.irradiance.size());
    transport.apply(light.emittance, direct, 0, transport.size(), context_);
    for (std::size_t i = 0; i < direct.size(); ++i) direct[i] += light.from_sky[i];
    std::vector<float> reflected(direct.size(), 0.0f);
    gauss_seidel(transport, {direct, light.scattering, reflected, light.irradiance}, {.tolerance = tolerance},
                 context_.quiet());
    for (std::size_t i = 0; i < reflected.size(); ++i) light.before[i] = light.emittance[i] + reflected[i];
    close(transport, light);
    return StopReason::converged;
  }

  StopReason eliminate(const DenseOperator& transport, RowLight& light) {
    report_.unshot_fraction = 1.0;
    auto leaves_first = light.emittance;  // E + rho D
    for (std::size_t i = 0; i < leaves_first.size(); ++i)
      leaves_first[i] += light.scattering.view().sent_on(light.from_sky, i, patches_.band_count());
    auto radiosity = leaves_first;
    if (!solve_directly(transport.factors(), leaves_first, light.scattering, radiosity, context_))
      return StopReason::stopped_by_user;
    report_.unshot_fraction = 0.0;
    light.before = std::move(radiosity);
    close(transport, light);
    return StopReason::converged;
  }

  SolveReport finish(const RowOperator& transport, const RowLight& light,
                     const std::vector<float>& standard_error, StopReason reason) {
    write_light(transport, light, standard_error, solution_);
    auto energy = energy_of(transport, light);
    report_.energy = std::move(energy.balance);
    report_.back_loss = std::move(energy.back_loss);
    report_.predicted_error = whole_error(light, standard_error);
    return sign(reason);
  }

  SolveReport& report() { return report_; }

 private:
  // H and B from the radiosity found.
  void close(const RowOperator& transport, RowLight& light) {
    transport.apply(light.before, light.irradiance, 0, transport.size(), context_);
    const auto scattering = light.scattering.view();
    for (std::size_t i = 0; i < light.radiosity.size(); ++i) light.irradiance[i] += light.from_sky[i];
    for (std::size_t i = 0; i < light.radiosity.size(); ++i)
      light.radiosity[i] =
          light.emittance[i] + scattering.sent_on(light.irradiance, i, patches_.band_count());
    show_light(transport, light);
  }

  // The monitor is polled again before the next stage.
  void show_light(const RowOperator& transport, const RowLight& light) {
    write_light(transport, light, {}, solution_);
    solution_.unshot_fraction = report_.unshot_fraction;
    const Progress progress{"light", 1.0 - report_.unshot_fraction};
    if (on_light_) on_light_(solution_, progress);
    context_.report(progress);
  }

  SolveReport sign(StopReason reason) {
    report_.stop = solution_.stop = reason;
    solution_.unshot_fraction = report_.unshot_fraction;
    solution_.predicted_error = report_.predicted_error;
    solution_.provenance.rays = report_.rays;
    return report_;
  }

  const PatchSet& patches_;
  Solution& solution_;
  const LightSink& on_light_;
  const Context& context_;
  SolveReport report_;
};

// Bound of the error of the light: the errors of the factors, propagated from side to side as light is.
std::vector<float> integration_errors(const DenseOperator& transport, const RowLight& light,
                                      const Context& context) {
  const auto gathered = transport.irradiance_error(light.before);
  const std::vector<float> direct(gathered.begin(), gathered.end());
  std::vector<float> reflected(direct.size(), 0.0f), error(direct.size(), 0.0f);
  gauss_seidel(transport, {direct, light.scattering, reflected, error}, {.tolerance = 0.01}, context.quiet());
  // The part of a row that is left for the sky is as accurate as the row's sum.
  const auto& patches = transport.patches();
  for (std::size_t i = 0; i < error.size(); ++i) {
    const auto sky = static_cast<float>(patches.sky_radiosity(0, i % patches.band_count()));
    error[i] += static_cast<float>(rounding) * (light.irradiance[i] + sky);
  }
  return error;
}

}  // namespace

SolveReport solve_dense(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                        const DenseSolveOptions& options, const Context& context, const LightSink& on_light) {
  ClassicalRun run(patches, solution, "dense", on_light, context);
  run.report().error_kind = ErrorKind::integration;
  auto transport = DenseOperator::make(patches, tracer, options.factors, context);
  if (!transport) return run.stopped_in_the_dark();
  if (!options.face.empty()) transport->join_faces(options.face);
  RowLight light(*transport);
  auto reason = StopReason::converged;
  switch (options.solver) {
    case DenseSolver::direct:
      reason = run.eliminate(*transport, light);
      break;
    case DenseSolver::jacobi:
      reason = run.iterate(*transport, light, options.iteration);
      break;
    case DenseSolver::gauss_seidel:
      reason = run.iterate_by_parts(*transport, light, options.iteration.tolerance);
      break;
  }
  return run.finish(*transport, light, integration_errors(*transport, light, context), reason);
}

SolveReport solve_hemicube(const PatchSet& patches, Solution& solution, const HemicubeSolveOptions& options,
                           const Context& context, const LightSink& on_light) {
  ClassicalRun run(patches, solution, "hemicube", on_light, context);
  run.report().error_kind = ErrorKind::unknown;
  const auto transport = HemicubeOperator::make(patches, options.hemicube, context);
  if (!transport) return run.stopped_in_the_dark();
  RowLight light(*transport);
  const auto reason = run.iterate(*transport, light, options.iteration);
  return run.finish(*transport, light, {}, reason);
}

SolveReport solve_lines(const PatchSet& patches, const Tracer& tracer, Solution& solution,
                        const LinesSolveOptions& options, const Context& context, const LightSink& on_light) {
  ClassicalRun run(patches, solution, "lines", on_light, context);
  solution.provenance.seed = options.lines.seed;
  const auto transport = LinesOperator::make(patches, tracer, options.lines, context);
  if (!transport) return run.stopped_in_the_dark();
  run.report().rays = std::uint64_t{options.lines.lines} * transport->size();
  RowLight light(*transport);
  const auto reason = run.iterate(*transport, light, options.iteration);
  const auto errors = line_errors(*transport, light, options.lines.seed, context);
  return run.finish(*transport, light, errors, reason);
}

}  // namespace luxel
