// SPDX-License-Identifier: Apache-2.0
#include "luxel/solve/relight.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/cli/accuracy_text.h"
#include "luxel/cli/colour_text.h"
#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/finish.h"
#include "luxel/cli/outputs.h"
#include "luxel/cli/page_output.h"
#include "luxel/cli/store_settings.h"
#include "luxel/patch/luminaire_groups.h"
#include "luxel/scene/name_pattern.h"
#include "luxel/session/words.h"

namespace luxel {
namespace {

// NAME=VALUE, may be repeated.
struct NamedValue {
  std::string name, text;
};

Declaration named_values(const char* name, const char* unit, const char* expected, const char* help,
                         std::vector<NamedValue>& values) {
  return {.name = name,
          .unit = unit,
          .help = help,
          .parse =
              [=, &values](const std::string& text) {
                const auto [key, value] = parse_named(name, text, expected);
                values.push_back({key, value});
              },
          .print =
              [&values] {
                std::vector<std::string> lines;
                for (const auto& v : values) lines.push_back(v.name + "=" + v.text);
                return fmt::format("{}", fmt::join(lines, "\n"));
              },
          .many = true};
}

// `relight`: changes lamps and colours without tracing rays.
class Relight final : public Command {
 public:
  explicit Relight(OptionSet& options) : Command(options) {
    options.set_positional("SOLUTION", file_, "a .vtkhdf file that 'luxel bake --store-transport' wrote",
                           ".vtkhdf");
    options.heading("Light");
    options.add(named_values("light", "GROUP=FACTOR", "GROUP=FACTOR, such as desk=0.3",
                             "multiply the power of a light group by a factor", lights_));
    options.add(
        named_values("tint", "GROUP=COLOUR", "GROUP=COLOUR, such as ceiling=#ffd0a0",
                     "colour of the group's light: #rrggbb, or linear red,green,blue; luminaires keep their "
                     "lumens",
                     tints_));
    options.add_texts("off", "GROUP", off_, "switch off a light group");
    options.add(named_values(
        "reflectance", "MATERIAL=COLOUR", "MATERIAL=COLOUR, such as wall=0.5,0.2,0.2",
        "new reflectance of a material, at most 0.98: #rrggbb, linear red,green,blue or one number",
        reflectances_));
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
    const auto changes_lamps = !lights_.empty() || !tints_.empty() || !off_.empty();
    const auto weight = lamp_weights(patches);
    const auto reflectance = new_reflectances(patches);

    console.announce("hierarchy");
    const auto tracer = record.stage("hierarchy", [&](auto&) { return Tracer(patches, context); });
    console.announce("transport");
    const auto options_then = sampled_options_of(kept.baked.solution.provenance);
    Relighter relighter(patches, tracer, kept.samples, options_then, context);
    console.announce("light");
    auto solution = record.stage("light", [&](auto&) {
      if (changes_lamps) relighter.set_lamps(weight);
      if (!reflectances_.empty()) relighter.set_reflectance(reflectance);
      return relighter.light();
    });
    console.clear_bar();
    Baked relit{relighter.patches(), std::move(solution)};
    join_light_groups(relit.patches);  // the light of single groups is not in the new file
    sign(relit, kept.baked.solution);
    console.say("scene", fmt::format("{} patches, {}", with_commas(patches.size()),
                                     counted_things(patches.group_count(), "light group")));
    console.say("error", accuracy_text(relit.solution));

    if (std::any_of(run_.outputs.begin(), run_.outputs.end(), is_picture))
      stand_still(camera_of(picture_, look_, kept.baked, tracer, context), patches);
    return write_and_finish(relit, &tracer, options(), {run_, look_, picture_}, {context, console, record});
  }

 private:
  // Returns the indices of the matching names; throws if there is none.
  std::vector<std::size_t> called(const std::string& option, const std::string& pattern,
                                  const std::vector<std::string>& names, const char* what) const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (matches(pattern, names[i])) found.push_back(i);
    if (found.empty())
      throw InputError(file_, fmt::format("--{}: there is no {} '{}', but {}", option, what, pattern,
                                          fmt::join(names, ", ")));
    return found;
  }

  // [group * bands + band].
  std::vector<float> lamp_weights(const PatchSet& patches) const {
    const auto bands = patches.band_count();
    std::vector<float> weight(patches.group_count() * bands, 1.0f);
    const auto names = patches.light_groups.empty() ? std::vector<std::string>{"all"} : patches.light_groups;
    const auto scale_group = [&](std::size_t g, const std::vector<float>& by, double factor) {
      for (std::size_t b = 0; b < bands; ++b) weight[g * bands + b] *= static_cast<float>(factor) * by[b];
    };
    const auto scale = [&](const std::string& option, const std::string& pattern,
                           const std::vector<float>& by) {
      for (const auto g : called(option, pattern, names, "light group")) scale_group(g, by, 1.0);
    };
    for (const auto& [name, text] : lights_) {
      const auto factor = parse_number(text);
      if (!factor || !(*factor >= 0.0f && *factor <= 1e9f))
        throw UsageError(fmt::format("--light {}: expected a number from 0 to 1e9, not '{}'", name, text));
      scale("light", name, std::vector(bands, *factor));
    }
    for (const auto& [name, text] : tints_) {
      const auto tint = colour_of_bands(fmt::format("--tint {}", name), text, patches, 1e9f);
      for (const auto g : called("tint", name, names, "light group")) {
        const auto lumens = relative_lumens(patches, g, tint);
        scale_group(g, tint, lumens > 0.0 ? 1.0 / lumens : 1.0);
      }
    }
    for (const auto& name : off_) scale("off", name, std::vector(bands, 0.0f));
    return weight;
  }

  // [material * bands + band].
  std::vector<float> new_reflectances(const PatchSet& patches) const {
    const auto most = LoadOptions().max_reflectance;  // the loader's limit
    std::vector<std::string> names;
    std::vector<float> reflectance;
    for (const auto& material : patches.materials) {
      names.push_back(material.name);
      reflectance.insert(reflectance.end(), material.reflectance.begin(), material.reflectance.end());
    }
    const auto bands = patches.band_count();
    for (const auto& [name, text] : reflectances_) {
      auto colour = colour_of_bands(fmt::format("--reflectance {}", name), text, patches, 1.0f);
      for (auto& r : colour) r = std::min(r, most);
      for (const auto m : called("reflectance", name, names, "material"))
        std::copy(colour.begin(), colour.end(), reflectance.begin() + static_cast<std::ptrdiff_t>(m * bands));
    }
    return reflectance;
  }

  // Keeps the camera: pictures of one room in several lights are taken from the place found for the original
  // light.
  void stand_still(const Camera& camera, const PatchSet& patches) {
    picture_.eye = patches.in_file(camera.eye);
    picture_.target = patches.in_file(camera.target);
    picture_.vertical_fov = camera.vertical_fov;
  }

  // Writes the provenance: the original one, and the changes.
  void sign(Baked& relit, const Solution& before) const {
    auto& solution = relit.solution;
    const auto rays = solution.provenance.rays;
    const auto fingerprint = solution.provenance.scene_fingerprint;
    solution.provenance = before.provenance;
    solution.provenance.rays = rays;
    solution.provenance.scene_fingerprint = fingerprint;
    solution.provenance.command_line += fmt::format("; {}", options().given_as_command(RunSettings::heading));
    for (const auto& [name, value] : options().given())
      if (name == "light" || name == "tint" || name == "off" || name == "reflectance")
        solution.provenance.options.emplace_back(name, value);
    solution.mesh_error = before.mesh_error;
    solution.stop = before.stop;
  }

  std::string file_;
  std::vector<NamedValue> lights_, tints_, reflectances_;
  std::vector<std::string> off_;
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
