// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>

#include "luxel/lighting/ugr_table.h"

namespace luxel {
namespace {

std::string cell(double ugr) {
  return std::isfinite(ugr) ? fmt::format(" {:8.1f}", ugr) : fmt::format(" {:>8}", "-");
}

}  // namespace

std::string name_of(const RoomReflectance& r) {
  return fmt::format("{:.0f}/{:.0f}/{:.0f}", 100.0 * r.ceiling, 100.0 * r.wall, 100.0 * r.floor);
}

std::string text_of(const UgrTable& table) {
  auto text = fmt::format("{:9}  {:^44}   {:^44}\n{:9}", "room", "seen crosswise", "seen endwise", "");
  for (int direction = 0; direction < 2; ++direction) {
    text += direction == 0 ? " " : "  ";
    for (const auto& reflectance : ugr_reflectances) text += fmt::format(" {:>8}", name_of(reflectance));
  }
  text += "\n";
  for (std::size_t r = 0; r < ugr_rooms.size(); ++r) {
    text += fmt::format("{:>3g}H x{:>2g}H ", ugr_rooms[r].across, ugr_rooms[r].along);
    for (const auto ugr : table.crosswise[r]) text += cell(ugr);
    text += "  ";
    for (const auto ugr : table.endwise[r]) text += cell(ugr);
    text += "\n";
  }
  return text;
}

std::string csv_of(const UgrTable& table) {
  std::string text = "across_H,along_H";
  for (const char* direction : {"crosswise", "endwise"})
    for (const auto& reflectance : ugr_reflectances)
      text += fmt::format(",{} {}", direction, name_of(reflectance));
  text += "\n";
  for (std::size_t r = 0; r < ugr_rooms.size(); ++r) {
    text += fmt::format("{:g},{:g}", ugr_rooms[r].across, ugr_rooms[r].along);
    for (const auto* values : {&table.crosswise, &table.endwise})
      for (const auto ugr : (*values)[r])
        text += std::isfinite(ugr) ? fmt::format(",{:.2f}", ugr) : std::string(",");
    text += "\n";
  }
  return text;
}

}  // namespace luxel
