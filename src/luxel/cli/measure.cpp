// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "luxel/cli/commands.h"
#include "luxel/cli/console.h"
#include "luxel/cli/solved_scene.h"
#include "luxel/cli/streams.h"
#include "luxel/cli/suggestion.h"
#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/patch/focus.h"
#include "luxel/render/solution_light.h"
#include "luxel/render/surface_measure.h"
#include "luxel/runs/run_record.h"
#include "luxel/runs/settings.h"
#include "luxel/solution/solution_file.h"

namespace luxel {
namespace {

using Json = nlohmann::ordered_json;

struct NamedMeasure {
  std::string name;
  SurfaceMeasure measure;
};

Json as_json(const MeasuredNumber& n) { return {{"value", n.value}, {"low", n.low}, {"high", n.high}}; }

std::string as_text(const MeasuredNumber& n) {
  return n.low < n.high ? fmt::format("{:.4g} ({:.4g}-{:.4g})", n.value, n.low, n.high)
                        : fmt::format("{:.4g}", n.value);
}

// `measure`: illuminance of surfaces by name.
class Measure final : public Command {
 public:
  explicit Measure(OptionSet& options) : Command(options) {
    options.set_positional("SOLUTION", file_, "a .vtkhdf file that 'luxel bake' wrote");
    options.heading("Surfaces");
    options.add_texts(
        "surface", "NAME", surfaces_,
        "name of a material or, with --scene, of an object or a group; * and ? stand for any text and "
        "any letter; without it, all materials are listed");
    options.add_choice("side", {"auto", "front", "back"}, side_,
                       "side that is measured; auto: the one that receives more light");
    options.add_text("scene", "FILE", scene_file_,
                     "the solved scene, which has the names of its objects and groups");
    run_.declare(options, "");
  }

  int run() override {
    Console console(run_);
    const Context context(run_.threads);
    RunRecord record;
    const auto stored = record.stage("read", [&](auto&) { return read_stored_run(file_); });
    const auto& patches = stored.baked.patches;
    const auto& solution = stored.baked.solution;
    check_has_lux(patches, file_);
    std::optional<SolvedScene> solved;
    if (!scene_file_.empty()) {
      solved = record.stage(
          "load", [&](auto&) { return load_solved_scene(scene_file_, file_, stored.baked, console); });
      if (!solved) return stopped_before_light(console);
      keep_files_of(solved->scene);
    }
    std::vector<std::vector<float>> replicates;
    if (stored.samples) replicates = replicate_illuminance(patches, *stored.samples, context);
    const SurfaceMeter meter(patches, solution, std::move(replicates));
    const auto* scene = solved ? &solved->scene : nullptr;
    std::vector<NamedMeasure> measures;
    for (const auto& name : surfaces_.empty() ? names_of_materials(patches) : surfaces_) {
      const auto selected = surfaces_.empty() ? of_material(patches, name) : called(patches, scene, name);
      measures.push_back({name, meter.measure(selected, side())});
    }
    print(measures, meter, patches);
    console.detail("stages", record.table());
    return exit_fine;
  }

 private:
  SurfaceSide side() const {
    return side_ == "front"  ? SurfaceSide::front
           : side_ == "back" ? SurfaceSide::back
                             : SurfaceSide::automatic;
  }

  // Materials that have patches, in the order of the file.
  static std::vector<std::string> names_of_materials(const PatchSet& patches) {
    std::vector<std::string> names;
    std::vector<bool> has_patches(patches.materials.size(), false);
    for (const auto m : patches.material) has_patches[static_cast<std::size_t>(m)] = true;
    for (std::size_t i = 0; i < has_patches.size(); ++i)
      if (has_patches[i] && std::find(names.begin(), names.end(), patches.materials[i].name) == names.end())
        names.push_back(patches.materials[i].name);
    return names;
  }

  static std::vector<std::uint32_t> of_material(const PatchSet& patches, const std::string& name) {
    std::vector<std::uint32_t> selected;
    for (std::size_t p = 0; p < patches.size(); ++p)
      if (patches.material_of(p).name == name) selected.push_back(static_cast<std::uint32_t>(p));
    return selected;
  }

  std::vector<std::uint32_t> called(const PatchSet& patches, const Scene* scene,
                                    const std::string& pattern) const {
    std::vector<std::uint32_t> selected;
    for (std::size_t p = 0; p < patches.size(); ++p)
      if (is_called(scene, patches, p, pattern)) selected.push_back(static_cast<std::uint32_t>(p));
    if (!selected.empty()) return selected;
    auto names = names_of_materials(patches);
    if (scene != nullptr) {
      names.insert(names.end(), scene->objects.begin(), scene->objects.end());
      names.insert(names.end(), scene->groups.begin(), scene->groups.end());
    }
    const auto nearest = nearest_name(pattern, names);
    throw InputError(file_,
                     fmt::format("--surface: no {} is called '{}'{}{}",
                                 scene != nullptr ? "material, object or group" : "material", pattern,
                                 nearest.empty() ? "" : fmt::format(", did you mean '{}'?", nearest),
                                 scene != nullptr ? "" : "; give --scene FILE for objects and groups"));
  }

  void print(const std::vector<NamedMeasure>& measures, const SurfaceMeter& meter,
             const PatchSet& patches) const {
    const auto json = json_of(measures, meter, patches);
    if (!run_.report.empty()) write_file(run_.report, json);
    print_result(run_.json ? json : table_of(measures, meter));
  }

  std::string json_of(const std::vector<NamedMeasure>& measures, const SurfaceMeter& meter,
                      const PatchSet& patches) const {
    const auto place = [&](std::uint32_t patch) {
      const auto at = patches.in_file(patches.centroid(patch));
      return Json{at.x, at.y, at.z};
    };
    Json json = {{"command", "measure"},
                 {"solution", file_},
                 {"errors_of_means", name(meter.errors_of_means())},
                 {"errors_of_extremes", meter.has_errors_of_patches() ? "patches" : "none"},
                 {"surfaces", Json::array()}};
    for (const auto& [name, m] : measures)
      json["surfaces"].push_back({{"name", name},
                                  {"side", m.back ? "back" : "front"},
                                  {"patches", m.patches},
                                  {"area_m2", m.area},
                                  {"unlit_area_m2", m.unlit},
                                  {"mean_lx", as_json(m.mean)},
                                  {"min_lx", as_json(m.min)},
                                  {"max_lx", as_json(m.max)},
                                  {"min_over_mean", as_json(m.min_over_mean)},
                                  {"min_over_max", as_json(m.min_over_max)},
                                  {"darkest_m", place(m.darkest)},
                                  {"brightest_m", place(m.brightest)}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }

  static std::string table_of(const std::vector<NamedMeasure>& measures, const SurfaceMeter& meter) {
    constexpr std::size_t columns = 8;
    std::vector<std::array<std::string, columns>> rows = {
        {"surface", "side", "area m²", "mean lx", "min lx", "max lx", "min/mean", "min/max"}};
    for (const auto& [name, m] : measures)
      rows.push_back({name, m.back ? "back" : "front", fmt::format("{:.4g}", m.area), as_text(m.mean),
                      as_text(m.min), as_text(m.max), as_text(m.min_over_mean), as_text(m.min_over_max)});
    std::array<std::size_t, columns> width{};
    const auto letters = [](const std::string& text) {  // of UTF-8
      return static_cast<std::size_t>(std::count_if(
          text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; }));
    };
    for (const auto& row : rows)
      for (std::size_t c = 0; c < columns; ++c) width[c] = std::max(width[c], letters(row[c]));
    std::string text;
    for (const auto& row : rows) {
      for (std::size_t c = 0; c < columns; ++c) {
        text += row[c];
        if (c + 1 < columns) text.append(width[c] - letters(row[c]) + 2, ' ');
      }
      text += "\n";
    }
    text += "\nIlluminance of the patches' means; in brackets 95 % intervals.\n";
    for (const auto& [name, m] : measures)
      if (m.unlit > 0.0) text += fmt::format("{}: without {:.4g} m² that no light reaches.\n", name, m.unlit);
    switch (meter.errors_of_means()) {
      case SolutionErrors::replicates:
        text += "Means: from the spread of the stored replicates.\n";
        break;
      case SolutionErrors::patches:
        text +=
            "Means: from the patches' standard errors as an upper bound; a solution with --store-transport "
            "has "
            "narrower ones.\n";
        break;
      case SolutionErrors::not_stated:
        return text + "The solution states no errors: there are no intervals.\n";
    }
    if (!meter.has_errors_of_patches()) return text + "Extremes: the solution states no errors of patches.\n";
    return text + "Extremes: from the patches' standard errors, for any patch that may be the extreme one.\n";
  }

  std::string file_, scene_file_;
  std::vector<std::string> surfaces_;
  std::string side_ = "auto";
  RunSettings run_;
};

}  // namespace

std::unique_ptr<Command> make_measure(CommandLine& line) {
  return std::make_unique<Measure>(
      line.command("measure", "measure the illuminance of surfaces: mean, minimum, maximum, uniformity"));
}

}  // namespace luxel
