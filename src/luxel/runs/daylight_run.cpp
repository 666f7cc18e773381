// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/daylight_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/name_list.h"
#include "luxel/import/set_daylight.h"
#include "luxel/scene/name_pattern.h"
#include "luxel/version.h"

namespace luxel {
namespace {

constexpr int subdivisions[] = {1, 2, 4};

struct NewTransmittance {
  std::string name;
  float tau = 0.0f;
};

NewTransmittance parsed(const std::string& text) {
  const auto equals = text.rfind('=');
  const auto tau = equals == std::string::npos ? std::nullopt : parse_number(text.substr(equals + 1));
  if (!tau || !(*tau >= 0.0f && *tau <= 1.0f) || equals == 0)
    throw UsageError(fmt::format(
        "--transmittance: expected the name of glass and a number from 0 to 1, such as glass=0.6, not '{}'",
        text));
  return {text.substr(0, equals), *tau};
}

// Throws InputError where no pane has the name.
void set_transmittance(const std::string& file, const NewTransmittance& change, PatchSet& patches) {
  std::vector<std::string> names;
  bool any = false;
  for (const auto& pane : patches.panes) {
    auto& material = patches.materials[static_cast<std::size_t>(pane.material)];
    if (std::find(names.begin(), names.end(), material.name) == names.end()) names.push_back(material.name);
    if (!matches(change.name, material.name)) continue;
    std::fill(material.transmittance.begin(), material.transmittance.end(), change.tau);
    any = true;
  }
  if (any) return;
  throw InputError(
      file, names.empty() ? "it has no panes of glass: give their materials a transmittance before the run, "
                            "such as --glass glass=0.99"
                          : fmt::format("--transmittance: there is no glass '{}', but {}", change.name,
                                        name_list(names)));
}

}  // namespace

void DaylightChanges::declare(OptionSet& set) {
  reflectances_.declare_reflectance(set);
  set.add_texts("transmittance", "GLASS=TAU", transmittances_,
                "new transmittance of panes, by the name of their material: a number from 0 to 1");
}

bool DaylightChanges::apply(const std::string& file, PatchSet& patches) const {
  if (reflectances_.has_reflectance()) {
    const auto reflectance = reflectances_.new_reflectances(file, patches);
    const auto bands = patches.band_count();
    for (std::size_t m = 0; m < patches.materials.size(); ++m)
      std::copy_n(reflectance.begin() + static_cast<std::ptrdiff_t>(m * bands), bands,
                  patches.materials[m].reflectance.begin());
  }
  for (const auto& text : transmittances_) set_transmittance(file, parsed(text), patches);
  return !transmittances_.empty();
}

void write_daylight_run(const std::filesystem::path& path, const DaylightAnswer& answer,
                        const std::string& command) {
  const auto& t = *answer.transport;
  auto solution = t.solution;
  auto& provenance = solution.provenance;
  provenance.program_version = LUXEL_VERSION;
  provenance.command_line = command;
  const auto number = [](double value) { return fmt::format("{}", value); };
  provenance.options = {{"error", number(t.options.error)},
                        {"seed", fmt::format("{}", t.options.seed)},
                        {"north", number(answer.question.north)}};
  write_solution(path, t.patches, solution, t.samples.get());
}

StoredDaylight read_daylight_run(const std::string& file, const DaylightChanges& changes,
                                 const Context& context) {
  auto stored = read_stored_run(file);
  auto& patches = stored.baked.patches;
  const auto& provenance = stored.baked.solution.provenance;
  StoredDaylight found;
  const auto& sky = patches.sky_patches;
  const auto* cut = std::find_if(std::begin(subdivisions), std::end(subdivisions), [&](int n) {
    return !sky.is_one() && sky.upper() == static_cast<std::size_t>(144 * n * n + 1);
  });
  if (!stored.samples || cut == std::end(subdivisions))
    throw InputError(file, "it is no run of daylight: 'luxel daylight SCENE -o RUN.vtkhdf' stores one");
  found.subdivision = *cut;
  found.up = sky.zenith();
  auto& t = found.transport;
  for (const auto& [name, value] : provenance.options) {
    const auto number = parse_double(value);
    if (name == "error" && number) t.options.error = *number;
    if (name == "north" && number) found.north = *number;
  }
  t.options.seed = provenance.seed;
  t.error = stored.baked.solution.seen_error;
  t.samples = std::move(stored.samples);
  t.traces_again = changes.apply(file, patches);
  t.patches = std::move(patches);
  t.solution = std::move(stored.baked.solution);
  t.tracer.emplace(t.patches, context);
  return found;
}

}  // namespace luxel
