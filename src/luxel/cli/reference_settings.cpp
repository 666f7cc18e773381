// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/reference_settings.h"

#include <fmt/format.h>

#include "luxel/cli/quantity.h"

namespace luxel {

PathOptions ReferenceSettings::paths() const {
  return {.limits = limits,
          .bounces_from = bounces_from == from_points ? BouncesFrom::points : BouncesFrom::patches,
          .seed = seed};
}

void ReferenceSettings::check() const {
  if (limits.samples == 0 && limits.error == 0.0)
    throw UsageError("--error 0 asks for no accuracy: give --samples to say when to stop");
}

void ReferenceSettings::declare(OptionSet& set) {
  set.heading("Light");
  set.add(
      {"error", "share",
       "go on until the standard error is this, such as 1% or 0.01: RMS over all surfaces by area, or over "
       "pixels; the seen error is reported beside it",
       [this](const std::string& text) {
         const auto share = parse_share(text);
         if (!share)
           throw UsageError(
               fmt::format("--error: expected a share below 1, such as 1% or 0.01, not '{}'", text));
         limits.error = *share;
       },
       [this] { return limits.error == 0.0 ? std::string("0") : as_share(limits.error); }});
  set.add({"samples", "count",
           "instead: so many paths a patch side, or a pixel, such as 2k; in batches of 16",
           [this](const std::string& text) {
             limits.samples = text == "auto" ? 0 : parse_count("samples", text);
           },
           [this] { return limits.samples == 0 ? std::string("auto") : fmt::format("{}", limits.samples); }});
  set.add_choice("bounces-from", {from_points, from_patches}, bounces_from,
                 "points: the light as it is; patches: the light that radiosity on this mesh has");
  set.add_count("seed", seed, "another seed gives another, independent answer");
}

}  // namespace luxel
