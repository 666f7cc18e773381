// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "luxel/cli/check_text.h"
#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/finish.h"
#include "luxel/cli/streams.h"
#include "luxel/core/output_file.h"
#include "luxel/export/export_coloured.h"
#include "luxel/render/automatic_camera.h"
#include "luxel/runs/lit_scene.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/settings.h"
#include "luxel/session/diagnostic_mesh.h"

namespace luxel {
namespace {

constexpr const char* kinds = ".glb";

class Check final : public Command {
 public:
  explicit Check(OptionSet& options) : Command(options) {
    scene_.declare_scene(options);
    scene_.declare_sky(options);
    scene_.declare_luminaires(options);
    scene_.declare_spectra(options);
    options.heading("Check");
    options.add_number("places", "count", places_, 0u, 1'000'000u,
                       "number of positions to list per diagnostic");
    options.add_flag("strict", strict_, "exit with 1 if there are errors or warnings");
    look_.declare_up(options);
    run_.declare(options, kinds);
    options.show_first({"output", "places", "strict", "weld", "orient", "scale", "json"});
    options.set_examples({{"luxel check room.obj", "Lists what is wrong with a scene, and where."},
                          {"luxel check room.obj -o faults.glb --open", "Shows it in colours."}});
  }

  int run() override {
    scene_.check();
    scene_.load.retriangulate = false;
    if (!run_.outputs.empty()) check_before_work(run_, {}, kinds);
    Console console(run_);
    const Context context(run_.threads);
    RunRecord record;
    const auto scene =
        record.stage("load", [&](auto&) { return load_lit_scene(scene_, "auto", context, console); });
    if (interrupted()) return stopped_before_light(console);
    keep_files_of(scene);
    const auto report = record.stage(
        "check", [&](auto&) { return diagnose(scene, {.places = places_}, console.reporting(context)); });
    console.clear_bar();
    for (const auto& output : run_.outputs)
      record.stage("write glb", [&](auto&) { write(output, scene, report, context); });

    const CheckText text{&scene, &report, run_.outputs, &options(), &record};
    report_end(record, {}, {}, console);
    const auto json = text.as_json();
    if (!run_.report.empty()) write_file(run_.report, json);
    print_result(run_.json ? json : text.as_text());
    if (!report.is_whole) return exit_stopped_early;
    return strict_ && report.count(Severity::error) + report.count(Severity::warning) > 0 ? exit_failed
                                                                                          : exit_fine;
  }

 private:
  void write(const std::string& output, const Scene& scene, const CheckReport& report,
             const Context& context) const {
    std::vector<ColouredMesh> meshes;
    for (auto& part : fault_parts(scene, report)) {
      const auto name_of = [](DiagnosticKind kind) {
        return fmt::format("{} ({})", name(kind), colour(kind).word);
      };
      meshes.push_back({part.kind ? name_of(*part.kind) : std::string("well (grey)"),
                        part.kind ? colour(*part.kind).linear : Vec3(0.4f), std::move(part.positions),
                        std::move(part.triangles)});
    }
    const auto patches = make_patches(scene, {.max_edge = no_max_edge}, context);
    export_coloured(output, fmt::format("diagnostics of {}", scene.source), meshes, up_of(look_, patches),
                    scene.origin);
  }

  SceneSettings scene_;
  LookSettings look_;
  RunSettings run_;
  std::uint32_t places_ = 5;
  bool strict_ = false;
};

}  // namespace

std::unique_ptr<Command> make_check(CommandLine& line) {
  return std::make_unique<Check>(
      line.command("check", "report defects of a scene, with positions, before solving it"));
}

}  // namespace luxel
