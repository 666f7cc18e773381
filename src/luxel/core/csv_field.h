// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace luxel {

// The text as a field of a CSV file (RFC 4180), in quotes where it needs them. Spreadsheets take a field that
// begins with = + - @ for a formula: such a text, which may come from an untrusted scene, gets an apostrophe
// before it.
std::string csv_field(std::string_view text);

}  // namespace luxel
