// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "luxel/photometry/weather_figures.h"

namespace luxel {

// The output of `luxel weather`.
std::string text_of(const Weather& weather, const WeatherFigures& figures);
std::string json_of(const Weather& weather, const WeatherFigures& figures);

}  // namespace luxel
