// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/schedule.h"

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/csv_table.h"

namespace luxel {
namespace {

constexpr std::string_view occupied_column = "occupied", all_blinds = "blinds";

double part_in(const CsvTable& table, std::string_view column) {
  const auto part = table.required_number(column);
  if (!(part >= 0.0 && part <= 1.0))
    table.refuse(
        fmt::format("the closed part of '{}' is {:g}, expected 0 (open) to 1 (closed)", column, part));
  return part;
}

}  // namespace

YearSchedule read_schedule(const std::filesystem::path& path, std::size_t records,
                           std::span<const WindowGroup> groups) {
  std::vector<std::string> names;
  for (const auto& group : groups) names.push_back(lower_case(group.name));
  std::vector<std::string_view> known = {occupied_column, all_blinds};
  known.insert(known.end(), names.begin(), names.end());
  CsvTable table(path, known);
  const bool has_all = table.has_column(all_blinds);
  std::vector<std::string_view> column_of(groups.size());
  for (std::size_t g = 0; g < names.size(); ++g)
    column_of[g] = table.has_column(names[g]) ? std::string_view(names[g])
                   : has_all                  ? all_blinds
                                              : std::string_view();
  const bool has_blinds =
      std::any_of(column_of.begin(), column_of.end(), [](auto column) { return !column.empty(); });

  YearSchedule schedule;
  if (has_blinds) schedule.closed.resize(groups.size());
  std::size_t rows = 0;
  for (; table.next(); ++rows) {
    if (table.has_column(occupied_column)) {
      const auto occupied = table.required_number(occupied_column);
      if (occupied != 0.0 && occupied != 1.0)
        table.refuse(fmt::format("'occupied' is {:g}, expected 0 or 1", occupied));
      schedule.occupied.push_back(occupied == 1.0 ? 1 : 0);
    }
    for (std::size_t g = 0; has_blinds && g < groups.size(); ++g)
      schedule.closed[g].push_back(column_of[g].empty() ? 0.0f
                                                        : static_cast<float>(part_in(table, column_of[g])));
  }
  if (rows != records)
    throw InputError(
        table.source(),
        fmt::format("the schedule has {} rows, the weather file {} records: expected a row for each "
                    "of them",
                    rows, records));
  return schedule;
}

}  // namespace luxel
