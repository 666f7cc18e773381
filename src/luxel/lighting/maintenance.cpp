// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/maintenance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace luxel {
namespace {

// Factors are single precision in a solution: 0.8 is 0.80000001 there.
double rounded(double factor) { return std::round(1e6 * factor) / 1e6; }

std::string text_of(const LuminaireMaintenance& m) {
  return m.is_uniform() ? fmt::format("{:.2f}", m.low) : fmt::format("{:.2f} to {:.2f}", m.low, m.high);
}

}  // namespace

LuminaireMaintenance luminaire_maintenance(const PatchSet& patches) {
  LuminaireMaintenance m;
  bool is_first = true;
  for (const auto& lamp : patches.point_lights) {
    if (lamp.light.kind != PointLightKind::luminaire) continue;
    const auto factor = rounded(static_cast<double>(lamp.light.maintenance));
    m.low = is_first ? factor : std::min(m.low, factor);
    m.high = is_first ? factor : std::max(m.high, factor);
    is_first = false;
  }
  return m;
}

std::optional<double> AppliedMaintenance::factor() const {
  if (!luminaires.is_uniform()) return std::nullopt;
  return luminaires.low * area.factor;
}

std::string AppliedMaintenance::text() const {
  if (is_initial()) return "initial";
  if (luminaires.is_initial()) return fmt::format("maintenance factor {:.2f}", area.factor);
  if (area.factor >= 1.0) return "maintenance factor of the luminaires " + text_of(luminaires);
  const auto both = factor() ? fmt::format("{:.2f} ", *factor()) : std::string();
  return fmt::format("maintenance factor {}(luminaires {}, area {:.2f})", both, text_of(luminaires),
                     area.factor);
}

std::string text_of(const MaintenanceFactor& m) {
  auto text = fmt::format("{:.2f}", m.factor);
  std::string parts;
  for (const auto& [name, part] : {std::pair{"LLMF", m.llmf}, {"LSF", m.lsf}, {"LMF", m.lmf}, {"RMF", m.rmf}})
    if (part) parts += fmt::format("{}{} {:g}", parts.empty() ? "" : ", ", name, *part);
  return parts.empty() ? text : text + " (" + parts + ")";
}

std::string maintenance_warning(const AppliedMaintenance& applied, const std::string& area) {
  if (!applied.is_twice()) return "";
  return fmt::format(
      "maintenance applies twice: the luminaires have the factor {}, and the area \"{}\" has {:.2f}; both "
      "are multiplied, so give one of them only",
      text_of(applied.luminaires), area, applied.area.factor);
}

}  // namespace luxel
