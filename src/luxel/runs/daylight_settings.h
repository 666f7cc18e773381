// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "luxel/import/load_scene.h"
#include "luxel/runs/option_set.h"
#include "luxel/runs/outside_settings.h"

namespace luxel {

// The options of the sky and of the sun around a scene.
struct DaylightSettings {
  std::string sky = "auto";
  OutsideSettings outside;
  std::string sun_illuminance = "auto";
  double north = 0.0;

  // --sky auto, and no sun: the scene gets the default light where it has no lamp.
  bool adds_default_light() const { return sky == "auto" && !has_sun(); }
  // Radiance of a uniform sky, W/(m² sr); 0 without a sky or with a sky of another kind.
  Vec3 even_radiance() const;
  // A sky by illuminance, or a sun; none where there is neither. Throws UsageError and InputError as
  // OutsideSettings::daylight() does.
  std::optional<Daylight> daylight() const;
  // Throws UsageError where options contradict each other.
  void check() const;
  void declare(OptionSet& set);

 private:
  bool has_sun() const { return !outside.sun.empty() || !outside.date.empty() || !outside.weather.empty(); }
  // The kind of sky for OutsideSettings; empty: another sky.
  std::string kind() const;
};

}  // namespace luxel
