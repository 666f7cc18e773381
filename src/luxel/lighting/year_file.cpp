// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/year_file.h"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "luxel/core/output_file.h"
#include "luxel/solution/hdf5_writer.h"

namespace luxel {
namespace {

void add_hours(Hdf5Writer& file, const DaylightYear& year, const Weather& weather) {
  std::vector<std::uint32_t> month, day;
  std::vector<double> time, duration, elevation, azimuth;
  std::vector<float> sky, sun;
  for (const auto& hour : year.hours()) {
    month.push_back(weather.hours[hour.record].month);
    day.push_back(weather.hours[hour.record].day);
    time.push_back(hour.time);
    duration.push_back(hour.duration);
    elevation.push_back(hour.sun.elevation);
    azimuth.push_back(hour.sun.azimuth);
    sky.push_back(static_cast<float>(hour.sky_illuminance));
    sun.push_back(static_cast<float>(hour.sun_illuminance));
  }
  file.add_group("hours");
  file.add_array("hours/month", flat(month));
  file.add_array("hours/day", flat(day));
  file.add_array("hours/time", flat(time), "h");
  file.add_array("hours/duration", flat(duration), "h");
  file.add_array("hours/sun_elevation", flat(elevation), "degrees");
  file.add_array("hours/sun_azimuth", flat(azimuth), "degrees");
  file.add_array("hours/sky_horizontal_illuminance", flat(sky), "lx");
  file.add_array("hours/sun_normal_illuminance", flat(sun), "lx");
}

// Closed blinds block the part 1 - transmittance of this light.
void add_groups(Hdf5Writer& file, const DaylightYear& year, const std::vector<float>& all) {
  if (!year.has_groups()) return;
  file.add_group("windows");
  for (std::size_t g = 0; g < year.groups().size(); ++g) {
    const auto group = fmt::format("windows/{}", g + 1);
    const auto through = year.through(g, all, year.replicates());
    file.add_group(group);
    file.add_word(group, "name", year.groups()[g].name);
    file.add_array(group + "/illuminance", table(std::span(through), year.hours().size(), year.points()),
                   "lx");
  }
}

void add_metric(Hdf5Writer& file, const std::string& name, const PointMetric& metric,
                const std::string& unit) {
  file.add_array("metrics/" + name, flat(metric.value), unit);
  file.add_array("metrics/" + name + "_standard_error", flat(metric.standard_error), unit);
}

}  // namespace

void write_year(const std::filesystem::path& path, const DaylightYear& year, const Weather& weather,
                const YearFilePoints& points, const YearReport& report) {
  const auto all = year.illuminance(year.replicates());
  const auto errors = illuminance_errors(year, all);
  const auto hours = year.hours().size(), count = year.points();
  Hdf5Writer file;
  file.add_word("/", "content", "daylight of a year at points");
  add_hours(file, year, weather);
  file.add_array("illuminance", table(std::span(all), hours, count), "lx");
  file.add_array("standard_error", table(std::span(errors), hours, count), "lx");
  file.add_array("direct_sun", table(std::span(year.direct_sun()), hours, count), "lx");
  add_groups(file, year, all);
  std::vector<double> position, normal;
  for (std::size_t i = 0; i < points.position.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      position.push_back(points.position[i][axis]);
      normal.push_back(points.normal[i][axis]);
    }
  file.add_group("points");
  file.add_array("points/position", table(std::span<const double>(position), count, 3), "m");
  file.add_array("points/normal", table(std::span<const double>(normal), count, 3), "1");
  if (points.columns > 0)
    file.add_number("points", "grid_columns", static_cast<std::uint64_t>(points.columns));
  file.add_group("metrics");
  const auto& m = report.metrics;
  add_metric(file, "daylight_autonomy_300", m.autonomy, "1");
  add_metric(file, "continuous_daylight_autonomy_300", m.continuous_autonomy, "1");
  add_metric(file, "udi_below_100", m.below_100, "1");
  add_metric(file, "udi_100_3000", m.useful, "1");
  add_metric(file, "udi_300_3000", m.autonomous, "1");
  add_metric(file, "udi_above_3000", m.above_3000, "1");
  add_metric(file, "annual_light_exposure", m.exposure, "lx h");
  add_metric(file, "direct_sun_hours_1000", m.sun_hours, "h");
  write_file(path, std::string(file.finish()));
}

}  // namespace luxel
