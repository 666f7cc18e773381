// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/file_date.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <optional>

#include <fmt/chrono.h>

#include "luxel/runs/option_set.h"

namespace luxel {
namespace {

std::optional<std::time_t> source_date() {
  const auto* text = std::getenv("SOURCE_DATE_EPOCH");
  const auto seconds = text == nullptr ? std::nullopt : parse_double(text);
  constexpr double max_seconds = 1e11;  // the year 5138
  if (!seconds || !(*seconds >= 0.0 && *seconds < max_seconds)) return std::nullopt;
  return static_cast<std::time_t>(*seconds);
}

}  // namespace

std::string day_of_file(const std::filesystem::path& path) {
  const auto written = std::chrono::file_clock::to_sys(std::filesystem::last_write_time(path));
  auto seconds = std::chrono::system_clock::to_time_t(
      std::chrono::time_point_cast<std::chrono::system_clock::duration>(written));
  if (const auto latest = source_date()) seconds = std::min(seconds, *latest);
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(seconds));
}

std::string today() {
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(source_date().value_or(std::time(nullptr))));
}

}  // namespace luxel
