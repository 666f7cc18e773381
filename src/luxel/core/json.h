// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace luxel {

// A JSON value that the library writes. Objects hold their members in the order in which these were added.
using Json = nlohmann::ordered_json;

// A JSON value with the members of each object in the order of their names, found in logarithmic time: for
// files that are read.
using SortedJson = nlohmann::json;

// Returns a value as JSON text on one line. Bytes that are not UTF-8, as names and paths may contain, become
// U+FFFD; infinite numbers and NaN become null. Throws nothing.
template <typename Value>
std::string json_text(const Value& value) {
  return value.dump(-1, ' ', false, Value::error_handler_t::replace);
}

}  // namespace luxel
