// SPDX-License-Identifier: Apache-2.0
#include "luxel/runs/view_factor_settings.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "luxel/core/ending_of.h"
#include "luxel/core/memory.h"
#include "luxel/runs/quantity.h"
#include "luxel/scene/name_pattern.h"

namespace luxel {
namespace {

// Size of a factor in an HDF5 file, which is built in memory.
constexpr std::uint32_t bytes_in_file = 16;
// Default tolerance of a row sum, for factors between patches.
constexpr double usual_row_error = 0.04;
constexpr double memory_fraction = 0.8;  // of the free memory

double parse_factor(const std::string& name, const std::string& text) {
  const auto value = parse_double(text);
  if (value && *value >= 0.0 && *value < 1.0) return *value;
  throw UsageError(
      fmt::format("--{}: expected a factor from 0 to below 1, such as 0.001, not '{}'", name, text));
}

// Some of the names, as text.
std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 8;
  auto text = fmt::format("{}", fmt::join(names.begin(), names.begin() + std::min(most, names.size()), ", "));
  if (names.size() > most) text += fmt::format(" and {} more", names.size() - most);
  return text;
}

}  // namespace

void ViewFactorSettings::declare(OptionSet& set) {
  set.heading("View factors");
  set.add_choice("between", {"groups", "objects", "materials", "patches"}, between,
                 "elements of the factors: OBJ groups (g or o), objects (o), materials, or all patches");
  set.add_choice(
      "sides", {"front", "both"}, sides,
      "front: fronts of surfaces; both: also the backs of two-sided materials, as elements of their own");
  set.add_texts("from", "NAME", from, "only the rows of these elements (with * and ?)");
  set.add(
      {"error", "factor",
       "stop at this RMS standard error of the view factors; auto: 0.001, between patches 4 % of a row, none "
       "with --rays",
       [this](const std::string& text) {
         error = text == "auto" ? std::optional<double>() : parse_factor("error", text);
       },
       [this] { return error ? fmt::format("{}", *error) : std::string("auto"); }});
  set.add({"rays", "count",
           "maximum number of rays per patch side (rounded down to a power of two per replicate)",
           [this](const std::string& text) { sampled.rays = text == "auto" ? 0 : parse_count("rays", text); },
           [this] { return sampled.rays == 0 ? std::string("auto") : fmt::format("{}", sampled.rays); }});
  set.add({"min-factor", "factor", "drop smaller factors; their sum is recorded",
           [this](const std::string& text) { sampled.min_factor = parse_factor("min-factor", text); },
           [this] { return fmt::format("{}", sampled.min_factor); }});
  set.add_flag("enforce", enforce,
               "make row sums and reciprocity exact by weighted least squares; reports the changes");
  set.add_flag("exact", is_exact,
               "closed forms, integrated where obstructed, instead of rays; for small scenes");
  set.add_flag("force", force, "start even if --exact is predicted to take long");
  set.add_count("seed", sampled.seed, "seed of the random numbers; other seeds give independent results");
  set.add_number("replicates", "count", sampled.replicates, 4u, 32u,
                 "independent estimates; their spread gives the standard errors");
}

void ViewFactorSettings::declare_memory(OptionSet& set) {
  const auto parse = [this](const std::string& text) {
    const auto bytes = text == "auto" ? std::optional(std::uint64_t{0}) : parse_bytes(text);
    if (!bytes)
      throw UsageError(
          fmt::format("--memory: expected a size such as 512MiB or 4GiB, or auto, not '{}'", text));
    sampled.memory = *bytes;
  };
  set.add_flag("compress", compress, "compress the HDF5 file: smaller, slower to write");
  set.add({"memory", "size",
           "maximum memory; a run that needs more is refused; auto: four fifths of the free memory", parse,
           [this] { return sampled.memory == 0 ? std::string("auto") : as_bytes(sampled.memory); }});
}

void ViewFactorSettings::check() const {
  if (error && *error == 0.0 && sampled.rays == 0 && !is_exact)
    throw UsageError("--error 0 sets no target: give --rays as the limit");
  if (enforce && !from.empty()) throw UsageError("--enforce needs the rows of all elements: remove --from");
  if (is_exact && !from.empty()) throw UsageError("--exact computes all rows: remove --from");
  if (is_exact && (error || sampled.rays > 0))
    throw UsageError("--exact uses no rays: remove --error and --rays");
}

Between ViewFactorSettings::kind() const {
  if (between == "objects") return Between::objects;
  if (between == "materials") return Between::materials;
  return between == "patches" ? Between::patches : Between::groups;
}

ElementSides ViewFactorSettings::element_sides() const {
  return sides == "both" ? ElementSides::both : ElementSides::front;
}

PatchOptions ViewFactorSettings::patch_options(PatchOptions given) const {
  // Closed forms need no small patches, and factors between patches are computed for the given ones.
  if (given.max_edge == automatic_edge && (kind() == Between::patches || is_exact))
    given.max_edge = no_max_edge;
  given.contacts = false;  // surfaces are used as described, and no light is drawn on them
  return given;
}

SampleFactorsOptions ViewFactorSettings::sample_options(const ViewElements& elements,
                                                        const std::vector<std::string>& outputs) const {
  auto options = sampled;
  const bool is_usual = !error && sampled.rays == 0;
  options.error = error.value_or(is_usual && kind() != Between::patches ? sampled.error : 0.0);
  if (is_usual && kind() == Between::patches) options.row_error = usual_row_error;
  options.rows = rows(elements);
  options.is_enforced = enforce;
  for (const auto& output : outputs)
    if (ending_of(output) == ".h5") options.bytes_beside = bytes_in_file;
  if (options.memory == 0)
    options.memory = static_cast<std::uint64_t>(memory_fraction * static_cast<double>(free_memory()));
  return options;
}

std::vector<std::uint8_t> ViewFactorSettings::rows(const ViewElements& elements) const {
  if (from.empty()) return {};
  std::vector<std::uint8_t> wanted(elements.size(), 0);
  for (const auto& pattern : from) {
    bool is_found = false;
    for (std::size_t e = 0; e < elements.size(); ++e)
      if (matches(pattern, elements.name[e])) {
        wanted[e] = 1;
        is_found = true;
      }
    if (!is_found)
      throw UsageError(fmt::format("--from: no element between {} is named '{}'; there are {}", between,
                                   pattern, some_of(elements.name)));
  }
  return wanted;
}

}  // namespace luxel
