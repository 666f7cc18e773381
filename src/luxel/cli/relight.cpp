// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/relight.h"

#include <algorithm>

#include <fmt/format.h>

#include "luxel/cli/accuracy_text.h"
#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/finish.h"
#include "luxel/runs/outputs.h"
#include "luxel/runs/page_output.h"
#include "luxel/runs/relight_changes.h"
#include "luxel/session/words.h"

namespace luxel {
namespace {

// `relight`: changes lamps and colours without tracing rays.
class Relight final : public Command {
 public:
  explicit Relight(OptionSet& options) : Command(options) {
    options.set_positional("SOLUTION", file_, "a .vtkhdf file that 'luxel bake --store-transport' wrote",
                           ".vtkhdf");
    options.heading("Light");
    changes_.declare(options);
    look_.declare(options);
    look_.declare_title(options);
    picture_.declare(options);
    picture_.declare_gather(options);
    run_.declare(options, all_kinds);
    options.show_first({"output", "light", "off", "tint", "reflectance", "eye", "target", "width", "height",
                        "exposure", "open"});
    options.set_examples({{"luxel relight room.vtkhdf --light lamp=0.3 -o evening.png", "The lamp at 30 %."},
                          {"luxel relight room.vtkhdf --off sun --reflectance wall=0.8,0.7,0.6 -o other.png",
                           "Without a light group, with another wall."}});
  }

  int run() override {
    check_before_work(run_, picture_, all_kinds);
    Console console(run_);
    const Context context(run_.threads);
    RunRecord record;
    auto kept = record.stage("read", [&](auto&) { return read_stored_run(file_); });
    if (!kept.samples)
      throw InputError(file_, "it stores no transport to relight with: bake with --store-transport");
    const auto& patches = kept.baked.patches;

    console.announce("hierarchy");
    const auto tracer = record.stage("hierarchy", [&](auto&) { return Tracer(patches, context); });
    console.announce("transport");
    const auto options_then = sampled_options_of(kept.baked.solution.provenance);
    Relighter relighter(patches, tracer, kept.samples, options_then, context);
    console.announce("light");
    const auto relit_baked = record.stage("light", [&](auto&) {
      changes_.apply(file_, patches, relighter);
      return relit(relighter, kept.baked.solution, options());
    });
    console.clear_bar();
    console.say("scene", fmt::format("{} patches, {}", with_commas(patches.size()),
                                     counted_things(patches.group_count(), "light group")));
    console.say("error", accuracy_text(relit_baked.solution));

    if (std::any_of(run_.outputs.begin(), run_.outputs.end(), is_picture))
      stand_still(camera_of(picture_, look_, kept.baked, tracer, context), patches);
    return write_and_finish(relit_baked, &tracer, options(), {run_, look_, picture_},
                            {context, console, record});
  }

 private:
  // Keeps the camera: pictures of one room in several lights are taken from the place found for the original
  // light.
  void stand_still(const Camera& camera, const PatchSet& patches) {
    picture_.eye = patches.in_file(camera.eye);
    picture_.target = patches.in_file(camera.target);
    picture_.vertical_fov = camera.vertical_fov;
  }

  std::string file_;
  RelightChanges changes_;
  LookSettings look_;
  PictureSettings picture_;
  RunSettings run_;
};

}  // namespace

std::unique_ptr<Command> make_relight(CommandLine& line) {
  return std::make_unique<Relight>(
      line.command("relight", "change lamps and colours of a solution without tracing rays"));
}

}  // namespace luxel
