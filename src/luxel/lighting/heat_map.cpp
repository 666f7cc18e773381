// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "luxel/lighting/chart_parts.h"
#include "luxel/lighting/svg_parts.h"

namespace luxel {
namespace {

constexpr std::size_t colour_classes = 40;  // of colours; the first is dark
constexpr std::array<unsigned, 12> days_of_month = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
constexpr std::array<const char*, 12> month_names = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                     "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};

unsigned days_in(std::size_t month, bool has_leap_day) {
  return days_of_month[month] + (month == 1 && has_leap_day ? 1u : 0u);
}

unsigned day_of_year(const WeatherHour& hour, bool has_leap_day) {
  unsigned day = hour.day - 1;
  for (std::size_t m = 0; m + 1 < hour.month; ++m) day += days_in(m, has_leap_day);
  return day;
}

ColourScale lux_scale() {
  ColourScale scale{.low = 10.0, .high = 100'000.0, .is_logarithmic = true};
  scale.marks = {10.0, 100.0, 300.0, 1000.0, 3000.0, 10'000.0, 100'000.0};
  scale.unit = "lx";
  return scale;
}

class HourMap {
 public:
  HourMap(const HeatMap& map, const DaylightYear& year, const Weather& weather)
      : map_(map), year_(year), weather_(weather) {
    for (std::size_t m = 0; m < 12; ++m) days_ += days_in(m, weather.has_leap_day);
    top_ = chart_title_height(map.figures.size());
    day_width_ = (width - left - right) / static_cast<double>(days_);
  }

  std::string svg() {
    constexpr double foot = 84.0;
    const auto bottom = top_ + 24.0 * hour_height;
    text_ = svg_begin(width, bottom + foot);
    text_ += chart_title_svg(map_.title, map_.figures, left);
    text_ += fmt::format("<rect x=\"{:g}\" y=\"{:g}\" width=\"{:g}\" height=\"{:g}\" fill=\"#999\"/>\n", left,
                         top_, width - left - right, 24.0 * hour_height);
    draw_cells();
    draw_axes(bottom);
    text_ += legend_svg(lux_scale(), left, bottom + 42.0, width - left - right - 40.0);
    return text_ + "</svg>\n";
  }

 private:
  static constexpr double left = 58.0, right = 24.0, width = 860.0, hour_height = 11.0;  // pixels

  // The class of colours of a record, 0 where it has no light.
  std::vector<std::size_t> classes_of_records() const {
    const auto scale = lux_scale();
    std::vector<std::size_t> found(weather_.hours.size(), 0);
    for (std::size_t h = 0; h < year_.hours().size(); ++h)
      found[year_.hours()[h].record] =
          static_cast<std::size_t>(std::lround(scale.fraction(static_cast<double>(map_.illuminance[h])) *
                                               static_cast<double>(colour_classes - 1)));
    return found;
  }

  // One path per colour in units of days and hours; records of a day with the same colour are joined.
  void draw_cells() {
    const auto of_record = classes_of_records();
    std::array<std::string, colour_classes> paths;
    const auto& hours = weather_.hours;
    for (std::size_t i = 0; i < hours.size();) {
      const auto begin = hours[i].end - hours[i].duration;
      const auto day = day_of_year(hours[i], weather_.has_leap_day);
      auto end = hours[i].end;
      std::size_t j = i + 1;
      for (; j < hours.size() && of_record[j] == of_record[i] && hours[j].day == hours[i].day &&
             hours[j].month == hours[i].month && std::abs(hours[j].end - hours[j].duration - end) < 1e-6;
           ++j)
        end = hours[j].end;
      paths[of_record[i]] += fmt::format("M{} {:.4g}h1V{:.4g}h-1z", day, 24.0 - begin, 24.0 - end);
      i = j;
    }
    text_ += fmt::format(
        "<svg x=\"{:g}\" y=\"{:g}\" width=\"{:g}\" height=\"{:g}\" viewBox=\"0 0 {} 24\" "
        "preserveAspectRatio=\"none\" shape-rendering=\"crispEdges\">\n",
        left, top_, width - left - right, 24.0 * hour_height, days_);
    const ColourScale even{.low = 0.0, .high = static_cast<double>(colour_classes - 1)};
    for (std::size_t c = 0; c < colour_classes; ++c)
      if (!paths[c].empty())
        text_ += fmt::format("<path class=\"hours\" fill=\"{}\" d=\"{}\"/>\n",
                             even.colour(static_cast<double>(c)), paths[c]);
    text_ += "</svg>\n";
  }

  double y_of(double hour) const { return top_ + (24.0 - hour) * hour_height; }

  void draw_axes(double bottom) {
    for (int hour = 0; hour <= 24; hour += 3) {
      text_ += fmt::format("<path d=\"M{:g} {:.1f}h-5\" stroke=\"#333\"/>\n", left, y_of(hour));
      text_ += svg_text(fmt::format("{}:00", hour), {left - 8.0, y_of(hour)}, "end", "#333");
    }
    for (const auto hour : {map_.from, map_.to})
      text_ += fmt::format(
          "<path class=\"occupied\" d=\"M{:g} {:.1f}H{:g}\" stroke=\"#fff\" stroke-dasharray=\"6 5\"/>\n",
          left, y_of(hour), width - right);
    double day = 0.0;
    for (std::size_t m = 0; m < 12; ++m) {
      const auto x = left + day_width_ * day, length = static_cast<double>(days_in(m, weather_.has_leap_day));
      text_ += fmt::format("<path d=\"M{:.1f} {:.1f}v6\" stroke=\"#333\"/>\n", x, bottom);
      text_ += svg_text(month_names[m], {x + 0.5 * length * day_width_, bottom + 12.0}, "middle", "#333");
      day += length;
    }
    text_ +=
        svg_text(fmt::format("local standard time; between the dashed lines occupied hours, {:g} to {:g}",
                             map_.from, map_.to),
                 {left, bottom + 29.0}, "start", "#333");
  }

  const HeatMap& map_;
  const DaylightYear& year_;
  const Weather& weather_;
  unsigned days_ = 0;
  double top_ = 0.0, day_width_ = 0.0;  // pixels
  std::string text_;
};

}  // namespace

std::vector<float> hourly_illuminance(const DaylightYear& year, std::optional<std::size_t> point) {
  const auto light = year.illuminance(year.replicates());
  const auto points = year.points();
  std::vector<float> hours;
  for (std::size_t h = 0; h < year.hours().size(); ++h) {
    if (point) {
      hours.push_back(light[h * points + *point]);
      continue;
    }
    double sum = 0.0;
    for (std::size_t m = 0; m < points; ++m) sum += static_cast<double>(light[h * points + m]);
    hours.push_back(static_cast<float>(sum / static_cast<double>(points)));
  }
  return hours;
}

std::string heat_map_svg(const HeatMap& map, const DaylightYear& year, const Weather& weather) {
  return HourMap(map, year, weather).svg();
}

}  // namespace luxel
