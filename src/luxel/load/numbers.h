// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "luxel/math/vector.h"

namespace luxel {

// A word that is one whole finite number that fits a float ("1", "+2.", ".8e-1"), rounded to the nearest; one
// too small for a float is 0. Anything else ("3.1+e2", "nan", "1e99") is nothing.
std::optional<float> read_number(std::string_view word);

// The first three words of a text as numbers, or nothing.
std::optional<Vec3> read_three_numbers(std::string_view text);

}  // namespace luxel
