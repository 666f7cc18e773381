// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "luxel/core/vector.h"

namespace luxel {

// A word that is one whole finite number no larger than floats go ("1", "+2.", ".8e-1"), to double precision.
// Anything else ("3.1+e2", "nan", "1e99") is nothing.
std::optional<double> read_precise_number(std::string_view word);

// Reads a number rounded to the nearest float; a number too small for a float is 0.
std::optional<float> read_number(std::string_view word);

// The first three words of a text as numbers, or nothing.
std::optional<Vec3d> read_three_precise_numbers(std::string_view text);
std::optional<Vec3> read_three_numbers(std::string_view text);

}  // namespace luxel
