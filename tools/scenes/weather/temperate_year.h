// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace luxel::scenes {

// A year of weather of our own as the text of a WEA file: 8760 hours at 50° north, 10° east, UTC+01:00, in
// W/m². No place has it; it serves examples and tests. With elevation h of the sun in the middle of the hour
// and relative air mass m (Kasten and Young 1989):
//
//     clear      direct normal 1353 * 0.7^(m^0.678) (Meinel and Meinel 1976), diffuse 110 sin(h)^0.4
//     overcast   direct normal 0, diffuse 300 sin(h)
//     broken     half of the direct normal of a clear day, diffuse the mean of both and 60 sin(h)
//
// Day d, from 1, has the number u = the fractional part of 0.618034 d, which fills [0, 1) evenly: it is clear
// below c = 0.27 - 0.13 cos(2 pi (d + 10) / 365), broken below c + 0.33, and overcast above.
std::string temperate_year();

}  // namespace luxel::scenes
