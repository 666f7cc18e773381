// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "luxel/scene/scene.h"

namespace luxel {

// Common words of the diagnostics.

std::string with_commas(std::size_t count);                       // 12,345
std::string counted_things(std::size_t count, const char* noun);  // "1 triangle", "1,234 triangles"
// "1 triangle has", "5 triangles have"; "... lies", "... lie"; "... is", "... are".
std::string counted_have(std::size_t count, const char* noun);
std::string counted_lie(std::size_t count, const char* noun);
std::string counted_is(std::size_t count, const char* noun);
std::string counted_are(std::size_t count);  // "1 is", "5 are"

std::string rounded(double number);    // three digits, without an exponent where there is a shorter way
std::string in_metres(double length);  // "0.3 mm", "2.1 m", "3 km"
std::string percent(double fraction);  // "12 %", "0.3 %", "below 0.1 %"
// "it lies on room.obj:12", with the material.
std::string lies_on(const Scene& scene, std::uint32_t triangle);

}  // namespace luxel
