// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/csv_field.h"

namespace luxel {

std::string csv_field(std::string_view text) {
  const bool is_formula = !text.empty() && std::string_view("=+-@\t\r").find(text[0]) != text.npos;
  std::string whole = is_formula ? "'" : "";
  whole += text;
  if (whole.find_first_of(",\"\r\n") == whole.npos) return whole;
  std::string quoted = "\"";
  for (const char c : whole) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace luxel
