// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/reference_settings.h"

#include <fmt/format.h>

#include "luxel/runs/quantity.h"

namespace luxel {

PathOptions ReferenceSettings::paths() const {
  return {.limits = limits,
          .bounces_from = bounces_from == from_points ? BouncesFrom::points : BouncesFrom::patches,
          .seed = seed};
}

void ReferenceSettings::check() const {
  if (limits.samples == 0 && limits.error == 0.0)
    throw UsageError("--error 0 sets no target: give --samples as the limit");
}

void ReferenceSettings::declare(OptionSet& set) {
  set.heading("Light");
  set.add(
      {"error", "fraction",
       "stop at this standard error, such as 1% or 0.01: area-weighted RMS over all surfaces, or RMS over "
       "pixels; the seen error is reported too",
       [this](const std::string& text) {
         const auto fraction = parse_fraction(text);
         if (!fraction)
           throw UsageError(
               fmt::format("--error: expected a fraction below 1, such as 1% or 0.01, not '{}'", text));
         limits.error = *fraction;
       },
       [this] { return limits.error == 0.0 ? std::string("0") : as_fraction(limits.error); }});
  set.add({"samples", "count",
           "instead of --error: paths per patch side or pixel, such as 2k; in batches of 16",
           [this](const std::string& text) {
             limits.samples = text == "auto" ? 0 : parse_count("samples", text);
           },
           [this] { return limits.samples == 0 ? std::string("auto") : fmt::format("{}", limits.samples); }});
  set.add_choice(
      "bounces-from", {from_points, from_patches}, bounces_from,
      "reflected light per point (exact), or per patch (what radiosity on this mesh converges to)");
  set.add_count("seed", seed, "seed of the random numbers; other seeds give independent results");
}

}  // namespace luxel
