// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/finish.h"
#include "luxel/cli/streams.h"
#include "luxel/cli/view_factor_report.h"
#include "luxel/core/ending_of.h"
#include "luxel/core/hint.h"
#include "luxel/core/memory.h"
#include "luxel/core/output_file.h"
#include "luxel/form_factors/view_factors_file.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/settings.h"
#include "luxel/runs/view_factor_settings.h"
#include "luxel/session/words.h"
#include "luxel/version.h"

namespace luxel {
namespace {

constexpr const char* kinds = ".h5 .csv .mtx";
constexpr double many_backs = 0.001;  // of the outgoing power

class ViewFactorsCommand final : public Command {
 public:
  explicit ViewFactorsCommand(OptionSet& options) : Command(options) {
    scene_.declare(options);
    settings_.declare(options);
    run_.declare(options, kinds);
    settings_.declare_memory(options);
    options.show_first(
        {"output", "between", "error", "rays", "max-edge", "sides", "from", "exact", "enforce"});
    options.set_examples(
        {{"luxel viewfactors room.obj -o room.csv", "Between the groups of the file, as a table."},
         {"luxel viewfactors room.obj --between patches --max-edge 0.5 -o room.h5", "Between patches."}});
  }

  int run() override {
    settings_.check();
    check_before_work(run_, {}, kinds);
    Console console(run_);
    const Context context(run_.threads);
    RunRecord record;

    // 1. The surfaces, and the elements.
    const auto scene = record.stage(
        "load", [&](auto&) { return load_scene(scene_.file, scene_.load, console.reporting(context)); });
    if (interrupted()) return stopped_before_factors(console);
    keep_files_of(scene);
    const auto patches = record.stage("patches", [&](auto&) {
      return make_patches(scene, settings_.patch_options(scene_.patches), console.reporting(context));
    });
    if (interrupted()) return stopped_before_factors(console);
    const auto elements = make_view_elements(scene, patches, settings_.kind(), settings_.element_sides());
    console.say("scene", fmt::format("{}: {} triangles, {} patches; view factors between {} {}", scene_.file,
                                     with_commas(scene.triangles.size()), with_commas(patches.size()),
                                     with_commas(elements.size()), settings_.between));
    const auto options_for_sampling = settings_.sample_options(elements, run_.outputs);
    console.announce("hierarchy");
    const auto tracer = record.stage("hierarchy", [&](auto&) { return Tracer(patches, context); });

    // 2. The factors.
    ViewFactorReport report;
    report.between = settings_.between;
    report.sides = settings_.sides;
    report.patches = patches.size();
    const auto reporting = console.reporting(context);
    auto factors = record.stage("factors", [&](auto& stage) {
      auto found = settings_.is_exact
                       ? exact(patches, tracer, elements, reporting, report)
                       : sampled(patches, tracer, elements, options_for_sampling, reporting, report);
      if (report.sampled) stage.rays = report.sampled->rays;
      return found;
    });
    if (!factors) return stopped_before_factors(console);

    // 3. The checks. Results are written even if stopped.
    report.factors = &*factors;
    const auto check = [&](auto&) { return check_view_factors(*factors, console.reporting(context)); };
    report.check = record.stage("check", check);
    if (settings_.enforce && !interrupted()) {
      report.enforcement =
          record.stage("enforce", [&](auto&) { return enforce_laws(*factors, console.reporting(context)); });
      report.check_after = record.stage("check", check);
    }
    console.say("factors", report.as_text());
    report_error_estimates(report, console);

    // 4. The requested files.
    const auto note = note_of(patches, elements, report);
    for (const auto& output : run_.outputs) {
      record.stage("write " + ending_of(output).substr(1), [&](auto&) { write(output, *factors, note); });
      report.outputs.push_back(output);
      console.wrote(output);
    }
    report.options = &options();
    report.record = &record;
    report_end(record, report.outputs, {}, console);
    const auto json = report.as_json();
    if (!run_.report.empty()) write_file(run_.report, json);
    if (run_.json) print_result(json);
    return fell_short(report) ? exit_stopped_early : exit_fine;
  }

 private:
  std::optional<ViewFactors> sampled(const PatchSet& patches, const Tracer& tracer,
                                     const ViewElements& elements, const SampleFactorsOptions& how,
                                     const Context& context, ViewFactorReport& report) const {
    report.sampled.emplace();
    report.error_target = how.error;
    report.row_error_target = how.row_error;
    const auto held = resident_memory();
    try {
      auto factors = sample_view_factors(patches, tracer, elements, how, *report.sampled, context);
      report.predicted_memory = held + report.sampled->predicted_bytes;
      return factors;
    } catch (const InputError& error) {
      throw with_file(scene_.file, error);
    }
  }

  std::optional<ViewFactors> exact(const PatchSet& patches, const Tracer& tracer,
                                   const ViewElements& elements, const Context& context,
                                   ViewFactorReport& report) const {
    report.exact.emplace();
    auto how = settings_.exact;
    how.min_factor = settings_.sampled.min_factor;
    if (settings_.force) how.seconds = 0.0;
    try {
      return exact_view_factors(patches, tracer, elements, how, *report.exact, context);
    } catch (const InputError& error) {
      throw with_file(scene_.file, error);
    }
  }

  bool is_enforced(const ViewFactorReport& report) const {
    return report.enforcement && !report.enforcement->is_stopped;
  }

  bool fell_short(const ViewFactorReport& report) const {
    if (!report.check.is_whole || (report.check_after && !report.check_after->is_whole) ||
        is_enforced(report) != settings_.enforce)
      return true;
    if (!report.sampled) return false;
    return report.sampled->stop == StopReason::stopped_by_user ||
           (report.sampled->stop == StopReason::ray_limit && report.error_target > 0.0);
  }

  void report_error_estimates(const ViewFactorReport& report, Console& console) const {
    if (settings_.enforce && !is_enforced(report))
      warn(console.log(), "stopped before the laws were enforced: the file says so");
    else if (!report.check.is_whole || (report.check_after && !report.check_after->is_whole))
      warn(console.log(), "stopped before all factors were checked");
    else if (fell_short(report) && report.sampled && report.error_target > 0.0)
      warn(console.log(),
           fmt::format("stopped before the requested error: standard error {:.3g}, requested {:g}",
                       report.sampled->error, report.error_target));
    if (report.check.backs > many_backs)
      warn(console.log(),
           fmt::format(
               "{:.2g} % of what leaves meets backs, which are no elements: --sides both counts those of "
               "two-sided materials, --flip turns faces round",
               100.0 * report.check.backs));
    if (report.enforcement && report.enforcement->worst_row_sum > 1e-6)
      warn(console.log(), fmt::format("row sums could be enforced to {:.2g} only: more rays would help",
                                      report.enforcement->worst_row_sum));
  }

  static int stopped_before_factors(Console& console) {
    warn(console.log(), "stopped before there were any factors to write: no file was written");
    return exit_stopped_early;
  }

  ViewFactorsNote note_of(const PatchSet& patches, const ViewElements& elements,
                          const ViewFactorReport& report) const {
    ViewFactorsNote note;
    note.between = settings_.between;
    note.sides = settings_.sides;
    note.enforced = is_enforced(report);
    note.provenance = {LUXEL_VERSION,
                       options().as_command(RunSettings::heading),
                       settings_.is_exact ? "exact" : "counted",
                       options().used_values(RunSettings::heading),
                       settings_.sampled.seed,
                       report.sampled ? report.sampled->rays : 0,
                       patches.scene_fingerprint,
                       {}};
    if (elements.kind != Between::patches) return note;
    note.origin = patches.origin;
    for (const auto p : elements.first_patch) {
      note.triangle.push_back(patches.triangle[p]);
      note.centre.push_back(patches.centroid(p));
    }
    return note;
  }

  void write(const std::string& output, const ViewFactors& factors, const ViewFactorsNote& note) const {
    if (ending_of(output) == ".csv") return write_view_factors_csv(output, factors);
    if (ending_of(output) == ".mtx") return write_view_factors_matrix_market(output, factors, note);
    write_view_factors_hdf5(output, factors, note, settings_.compress);
  }

  SceneSettings scene_;
  ViewFactorSettings settings_;
  RunSettings run_;
};

}  // namespace

std::unique_ptr<Command> make_viewfactors(CommandLine& line) {
  return std::make_unique<ViewFactorsCommand>(
      line.command("viewfactors", "view factors between groups, materials or patches, with standard errors"));
}

}  // namespace luxel
