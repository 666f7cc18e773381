// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/relight_changes.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/import/load_scene.h"
#include "luxel/patch/light_groups.h"
#include "luxel/patch/luminaire_groups.h"
#include "luxel/runs/colour_text.h"
#include "luxel/runs/settings.h"
#include "luxel/runs/store_settings.h"
#include "luxel/scene/name_pattern.h"

namespace luxel {
namespace {

// Returns the indices of the matching names; throws if there is none.
std::vector<std::size_t> called(const std::string& file, const std::string& option,
                                const std::string& pattern, const std::vector<std::string>& names,
                                const char* what) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (matches(pattern, names[i])) found.push_back(i);
  if (found.empty())
    throw InputError(file, fmt::format("--{}: there is no {} '{}', but {}", option, what, pattern,
                                       fmt::join(names, ", ")));
  return found;
}

}  // namespace

Declaration RelightChanges::named_values(const char* name, const char* unit, const char* expected,
                                         const char* help, std::vector<NamedValue>& values) {
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

void RelightChanges::declare(OptionSet& set) {
  set.add(named_values("light", "GROUP=FACTOR", "GROUP=FACTOR, such as desk=0.3",
                       "multiply the power of a light group by a factor", lights_));
  set.add(
      named_values("tint", "GROUP=COLOUR", "GROUP=COLOUR, such as ceiling=#ffd0a0",
                   "colour of the group's light: #rrggbb, or linear red,green,blue; luminaires keep their "
                   "lumens",
                   tints_));
  set.add_texts("off", "GROUP", off_, "switch off a light group");
  declare_reflectance(set);
}

void RelightChanges::declare_reflectance(OptionSet& set) {
  set.add(named_values(
      "reflectance", "MATERIAL=COLOUR", "MATERIAL=COLOUR, such as wall=0.5,0.2,0.2",
      "new reflectance of a material, at most 0.98: #rrggbb, linear red,green,blue or one number",
      reflectances_));
}

void RelightChanges::apply(const std::string& file, const PatchSet& patches, Relighter& relighter,
                           bool resets) const {
  if (resets || !lights_.empty() || !tints_.empty() || !off_.empty())
    relighter.set_lamps(lamp_weights(file, patches));
  if (resets || !reflectances_.empty()) relighter.set_reflectance(new_reflectances(file, patches));
}

// [group * bands + band].
std::vector<float> RelightChanges::lamp_weights(const std::string& file, const PatchSet& patches) const {
  const auto bands = patches.band_count();
  std::vector<float> weight(patches.group_count() * bands, 1.0f);
  const auto names = patches.light_groups.empty() ? std::vector<std::string>{"all"} : patches.light_groups;
  const auto scale_group = [&](std::size_t g, const std::vector<float>& by, double factor) {
    for (std::size_t b = 0; b < bands; ++b) weight[g * bands + b] *= static_cast<float>(factor) * by[b];
  };
  const auto scale = [&](const std::string& option, const std::string& pattern,
                         const std::vector<float>& by) {
    for (const auto g : called(file, option, pattern, names, "light group")) scale_group(g, by, 1.0);
  };
  for (const auto& [name, text] : lights_) {
    const auto factor = parse_number(text);
    if (!factor || !(*factor >= 0.0f && *factor <= 1e9f))
      throw UsageError(fmt::format("--light {}: expected a number from 0 to 1e9, not '{}'", name, text));
    scale("light", name, std::vector(bands, *factor));
  }
  for (const auto& [name, text] : tints_) {
    const auto tint = colour_of_bands(fmt::format("--tint {}", name), text, patches, 1e9f);
    for (const auto g : called(file, "tint", name, names, "light group")) {
      const auto lumens = relative_lumens(patches, g, tint);
      scale_group(g, tint, lumens > 0.0 ? 1.0 / lumens : 1.0);
    }
  }
  for (const auto& name : off_) scale("off", name, std::vector(bands, 0.0f));
  return weight;
}

// [material * bands + band].
std::vector<float> RelightChanges::new_reflectances(const std::string& file, const PatchSet& patches) const {
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
    for (const auto m : called(file, "reflectance", name, names, "material"))
      std::copy(colour.begin(), colour.end(), reflectance.begin() + static_cast<std::ptrdiff_t>(m * bands));
  }
  return reflectance;
}

Baked relit(const Relighter& relighter, const Solution& before, const OptionSet& options) {
  Baked result{relighter.patches(), relighter.light()};
  join_light_groups(result.patches);  // the light of single groups is not in the new file
  auto& solution = result.solution;
  const auto rays = solution.provenance.rays;
  const auto fingerprint = solution.provenance.scene_fingerprint;
  solution.provenance = before.provenance;
  solution.provenance.rays = rays;
  solution.provenance.scene_fingerprint = fingerprint;
  solution.provenance.command_line += fmt::format("; {}", options.given_as_command(RunSettings::heading));
  for (const auto& [name, value] : options.given())
    if (name == "light" || name == "tint" || name == "off" || name == "reflectance")
      solution.provenance.options.emplace_back(name, value);
  solution.mesh_error = before.mesh_error;
  solution.stop = before.stop;
  return result;
}

}  // namespace luxel
