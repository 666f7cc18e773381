// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/year_settings.h"

#include <optional>

#include <fmt/format.h>

namespace luxel {
namespace {

constexpr double not_stated = -1.0;

}  // namespace

void YearSettings::declare(OptionSet& options) {
  options.heading("Year");
  options.add({"occupied", "FROM-TO", "occupied hours of every day, local standard time, such as 8-18",
               [this](const std::string& text) { parse_occupied(text); },
               [this] { return fmt::format("{:g}-{:g}", metrics_.from, metrics_.to); }});
  Declaration blinds{
      "blinds", "NAME[=TAU]",
      "windows whose blinds are operated together, by the name of their glass's material, object or group (* "
      "and "
      "?), and the part of light that these let through when closed; repeatable. Without it all windows are "
      "one group",
      [this](const std::string& text) { parse_blinds(text); },
      [this] {
        std::string lines;
        for (const auto& group : groups_) {
          if (!lines.empty()) lines += "\n";
          lines += group.transmittance == not_stated
                       ? group.name
                       : fmt::format("{}={:g}", group.name, group.transmittance);
        }
        return lines;
      }};
  blinds.many = true;
  options.add(std::move(blinds));
  options.add_number("blind-transmittance", "0..1", transmittance_, 0.0, 1.0,
                     "part of all light through windows that closed blinds let through; blinds are closed in "
                     "hours when more than 2 % of the points have more than 1,000 lx straight from the sun");
  Declaration schedule{
      "schedule", "FILE",
      "CSV with a row for each record of the weather file and columns of these names: occupied (0 or 1, in "
      "place of --occupied); blinds, or the name of a group of windows (0 open to 1 closed, in place of the "
      "rule)",
      [this](const std::string& text) { schedule_ = text; }, [this] { return schedule_; }};
  schedule.endings = ".csv";
  options.add(std::move(schedule));
  options.add_number("lighting-power", "W", metrics_.lighting.power, 0.0, 1e9,
                     "power of the lamps that photosensors dim: reports the energy that this saves");
  options.add_number("lighting-level", "lx", metrics_.lighting.level, 1.0, 1e6,
                     "illuminance that lamps and daylight hold together, in the mean over the points");
}

void YearSettings::check(bool has_weather) const {
  if (has_weather) return;
  const auto refuse = [](const char* option) {
    throw UsageError(fmt::format("{} belongs to the hours of a year: give --weather FILE", option));
  };
  if (!groups_.empty()) refuse("--blinds");
  if (!schedule_.empty()) refuse("--schedule");
  if (metrics_.lighting.power > 0.0) refuse("--lighting-power");
}

std::vector<WindowGroup> YearSettings::groups() const {
  auto groups = groups_;
  for (auto& group : groups)
    if (group.transmittance == not_stated) group.transmittance = transmittance_;
  return groups;
}

MetricOptions YearSettings::metrics(const Weather& weather) const {
  auto metrics = metrics_;
  if (!schedule_.empty())
    metrics.schedule = read_schedule(schedule_, weather.hours.size(),
                                     groups_.empty() ? all_windows(transmittance_).groups : groups());
  return metrics;
}

void YearSettings::parse_occupied(const std::string& text) {
  const auto dash = text.find('-');
  const auto from = dash == std::string::npos ? std::nullopt : parse_double(text.substr(0, dash));
  const auto to = dash == std::string::npos ? std::nullopt : parse_double(text.substr(dash + 1));
  if (!from || !to || !(*from >= 0.0 && *to <= 24.0 && *from < *to))
    throw UsageError(fmt::format("--occupied: expected two hours of a day such as 8-18, not '{}'", text));
  metrics_.from = *from;
  metrics_.to = *to;
}

void YearSettings::parse_blinds(const std::string& text) {
  const auto equals = text.rfind('=');
  const auto tau =
      equals == std::string::npos ? std::optional(not_stated) : parse_double(text.substr(equals + 1));
  const auto name = text.substr(0, equals);
  if (name.empty() || !tau || (equals != std::string::npos && !(*tau >= 0.0 && *tau <= 1.0)))
    throw UsageError(fmt::format(
        "--blinds: expected the name of windows, and perhaps the part of light that closed blinds let "
        "through, such as south or south=0.1, not '{}'",
        text));
  groups_.push_back({name, *tau});
}

}  // namespace luxel
