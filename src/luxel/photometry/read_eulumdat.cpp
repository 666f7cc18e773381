// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/read_eulumdat.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/photometry/planes.h"

namespace luxel {
namespace {

constexpr std::size_t header_lines = 26;
constexpr std::size_t lines_per_lamp_set = 6;
constexpr std::size_t direct_ratios = 10;
constexpr std::size_t max_lamp_sets = 1000;

// A number with a decimal point or comma; an empty line is 0.
std::optional<double> decimal_of(std::string_view text) {
  std::string word(without_blanks(text.substr(0, 64)));
  if (word.empty()) return 0.0;
  std::replace(word.begin(), word.end(), ',', '.');
  return number_of(word);
}

// The lines of the header by their numbers in the format, from 1.
class HeaderLines {
 public:
  explicit HeaderLines(const PhotometrySource& source) : source_(source) {}

  std::string_view text(std::size_t line) const {
    if (line > source_.lines.size())
      throw InputError(source_.file, std::max<std::size_t>(1, source_.lines.size()),
                       fmt::format("expected line {} of a EULUMDAT file, found the end of it", line));
    return source_.lines[line - 1];
  }
  double number(std::size_t line, std::string_view what) const {
    const auto value = decimal_of(text(line));
    if (!value)
      throw InputError(source_.file, line,
                       fmt::format("expected {}, a number, found '{}'", what, excerpt_of(text(line))));
    return *value;
  }
  std::size_t count(std::size_t line, std::string_view what, std::size_t low, std::size_t high) const {
    const auto value = number(line, what);
    if (!(value >= static_cast<double>(low) && value <= static_cast<double>(high)) ||
        value != std::floor(value))
      throw InputError(
          source_.file, line,
          fmt::format("expected {}, a whole number from {} to {}, found {:g}", what, low, high, value));
    return static_cast<std::size_t>(value);
  }

 private:
  const PhotometrySource& source_;
};

struct Counts {
  std::size_t symmetry = 0, planes = 0, gammas = 0, lamp_sets = 0;
  double factor = 1.0;

  // The index of the first plane whose values are in the file, and their number.
  std::size_t first() const { return symmetry == 3 ? planes - planes / 4 : 0; }
  std::size_t stored() const {
    if (symmetry == 1) return 1;
    if (symmetry == 2 || symmetry == 3) return planes / 2 + 1;
    return symmetry == 4 ? planes / 4 + 1 : planes;
  }
};

Counts read_counts(PhotometrySource& source, const HeaderLines& header) {
  Counts counts;
  counts.symmetry = header.count(3, "the symmetry", 0, 4);
  counts.planes = header.count(4, "the number of C planes", 1, max_intensities);
  counts.gammas = header.count(6, "the number of gamma angles", 2, max_intensities);
  if (counts.planes * counts.gammas > max_intensities)
    throw InputError(source.file, 6,
                     fmt::format("expected at most {} intensities, found {} planes of {}", max_intensities,
                                 counts.planes, counts.gammas));
  const auto divisor = counts.symmetry == 4 || counts.symmetry == 3 ? 4 : counts.symmetry == 2 ? 2 : 1;
  if (counts.planes % divisor != 0)
    throw InputError(source.file, 4,
                     fmt::format("expected a number of C planes that {} divides for symmetry {}, found {}",
                                 divisor, counts.symmetry, counts.planes));
  counts.factor = header.number(24, "the conversion factor");
  if (!(counts.factor > 0.0)) {
    source.warn(24, fmt::format("the conversion factor is {:g}: 1 is taken", counts.factor));
    counts.factor = 1.0;
  }
  counts.lamp_sets = header.count(26, "the number of lamp sets", 0, max_lamp_sets);
  return counts;
}

void read_names(PhotometrySource& source, const HeaderLines& header) {
  auto& result = source.result;
  result.format = "EULUMDAT";
  result.maker = name_of(header.text(1));
  result.test_report = name_of(header.text(8));
  result.luminaire = name_of(header.text(9));
  result.catalogue = name_of(header.text(10));
}

// The luminous area: a box where it has sides, round where its width is 0.
void read_opening(PhotometrySource& source, const HeaderLines& header) {
  constexpr double mm = 1e-3;
  double sizes[6], low = 1e30, high = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < 6; ++i)
    sizes[i] = mm * std::abs(header.number(16 + i, "a size of the luminous area"));
  for (std::size_t i = 2; i < 6; ++i) {
    low = std::min(low, sizes[i]);
    high = std::max(high, sizes[i]);
    sum += sizes[i];
  }
  auto& opening = source.result.opening;
  const auto length = sizes[0], width = sizes[1], height = 0.25 * sum;
  if (length == 0.0 && width == 0.0 && high == 0.0) {
    if (header.number(13, "the luminaire's length") > 0.0)
      source.warn(16, "the luminous area has no size: a point is taken");
    return;
  }
  if (high - low > 0.05 * high)
    source.warn(
        18, fmt::format("the luminous area is {:g} to {:g} m high on its four sides: the mean is taken", low,
                        high));
  if (width == 0.0 && length > 0.0)
    opening = {high > 0.0 ? OpeningShape::vertical_cylinder : OpeningShape::ellipse,
               {length, length, height}};
  else
    opening = {high > 0.0 ? OpeningShape::box : OpeningShape::rectangle, {width, length, height}};
}

void read_lamps(PhotometrySource& source, const HeaderLines& header, const Counts& counts,
                const PhotometryOptions& options) {
  auto& result = source.result;
  for (std::size_t i = 0; i < counts.lamp_sets; ++i) {
    const auto line = header_lines + 1 + i * lines_per_lamp_set;
    LampSet lamp;
    lamp.count = header.number(line, "the number of lamps");
    lamp.name = name_of(header.text(line + 1));
    lamp.flux = header.number(line + 2, "the flux of the lamps");
    lamp.colour = name_of(header.text(line + 3));
    lamp.colour_rendering = name_of(header.text(line + 4));
    lamp.watts = std::max(0.0, header.number(line + 5, "the watts"));
    result.lamps.push_back(std::move(lamp));
  }
  if (options.lamp_set < 1 || options.lamp_set > std::max<std::size_t>(1, counts.lamp_sets))
    throw InputError(
        source.file, header_lines,
        fmt::format("there is no lamp set {}, the file has {}", options.lamp_set, counts.lamp_sets));
  result.lamp_set = options.lamp_set - 1;
  if (counts.lamp_sets > 1)
    source.warn(header_lines, fmt::format("the file has {} alternative sets of lamps: set {} is taken",
                                          counts.lamp_sets, options.lamp_set));
}

// lm that the values of cd/klm are for. Absolute photometry has a negative number of lamps.
double find_flux(PhotometrySource& source) {
  auto& result = source.result;
  if (result.lamps.empty()) {
    source.warn(header_lines, "the file has no lamps: values are taken as cd");
    result.absolute = true;
    return 1000.0;
  }
  const auto line = header_lines + 1 + result.lamp_set * lines_per_lamp_set;
  auto& chosen = result.lamps[result.lamp_set];
  result.absolute = chosen.count < 0.0;
  auto flux = std::abs(chosen.flux);
  if (flux == 0.0) {
    source.warn(line + 2, "the flux of the lamps is 0: values are taken as cd");
    result.absolute = true;
    flux = 1000.0;
  }
  for (auto& lamp : result.lamps) {
    if (lamp.count < 0.0) lamp.flux = 0.0;
    lamp.count = std::abs(lamp.count);
    lamp.flux = std::abs(lamp.flux);
  }
  return flux;
}

// All numbers after the header, in order, each with its line.
struct Values {
  std::vector<double> number;
  std::vector<std::size_t> line;
};

Values read_values(const PhotometrySource& source, std::size_t first_line, std::size_t most) {
  Values values;
  for (auto i = first_line - 1; i < source.lines.size() && values.number.size() < most; ++i) {
    auto rest = source.lines[i];
    for (auto word = take_word(rest, false); !word.empty(); word = take_word(rest, false)) {
      const auto value = decimal_of(word);
      if (!value)
        throw InputError(source.file, i + 1, fmt::format("expected a number, found '{}'", excerpt_of(word)));
      values.number.push_back(*value);
      values.line.push_back(i + 1);
    }
  }
  return values;
}

std::vector<double> take_angles(const PhotometrySource& source, const Values& values, std::size_t first,
                                std::size_t count, const char* kind) {
  std::vector<double> angles;
  for (auto i = first; i < first + count; ++i) {
    const auto angle = values.number[i];
    if (!(angle >= 0.0 && angle <= 360.0))
      throw InputError(source.file, values.line[i],
                       fmt::format("expected a {} angle of 0 to 360 degrees, found {:g}", kind, angle));
    if (!angles.empty() && !(angle > angles.back()))
      throw InputError(
          source.file, values.line[i],
          fmt::format("expected ascending {} angles, found {:g} after {:g}", kind, angle, angles.back()));
    angles.push_back(angle);
  }
  return angles;
}

// The C angles of the planes whose values are stored, in the order of the values; symmetry 3 begins at C270,
// which is -90 here.
std::vector<double> stored_angles(const PhotometrySource& source, const Counts& counts,
                                  const std::vector<double>& all, std::size_t line) {
  if (all.size() == counts.stored() && counts.symmetry != 3) return all;
  std::vector<double> stored;
  if (counts.symmetry == 3) {
    for (const auto angle : all)
      if (angle >= 270.0 - 1e-6 && angle < 360.0) stored.push_back(angle - 360.0);
    for (const auto angle : all)
      if (angle <= 90.0 + 1e-6) stored.push_back(angle);
  } else {
    stored.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(counts.stored()));
  }
  const auto first = stored.empty() ? 0.0 : stored.front(), last = stored.empty() ? 0.0 : stored.back();
  const auto expected = counts.symmetry == 4 ? 90.0 : counts.symmetry == 3 ? 90.0 : 180.0;
  const bool is_range =
      std::abs(last - expected) < 1e-3 && (counts.symmetry != 3 || std::abs(first + 90.0) < 1e-3);
  if (counts.symmetry != 1 && (stored.size() != counts.stored() || !is_range))
    throw InputError(
        source.file, line,
        fmt::format("expected C angles whose {} planes of symmetry {} end at C{:g}, found {} planes that "
                    "end at C{:g}",
                    counts.stored(), counts.symmetry, expected, stored.size(), last));
  return stored;
}

void read_intensity(PhotometrySource& source, const Counts& counts, double flux) {
  const auto first_line = header_lines + 1 + counts.lamp_sets * lines_per_lamp_set + direct_ratios;
  const auto stored = counts.stored(), intensities = stored * counts.gammas;
  const auto whole = counts.planes + counts.gammas + intensities;
  auto values = read_values(source, first_line, whole);
  const auto last_line = source.lines.size();
  auto planes = counts.planes;
  if (values.number.size() == stored + counts.gammas + intensities && stored < planes &&
      values.number[stored] <= values.number[stored - 1]) {
    planes = stored;
    source.warn(first_line, "the file has the C angles of its stored planes only");
  } else if (values.number.size() < whole) {
    const auto missing = whole - values.number.size();
    if (missing >= counts.gammas)
      throw InputError(source.file, last_line,
                       fmt::format("expected {} angles and intensities from line {} on, found {}", whole,
                                   first_line, values.number.size()));
    source.warn(last_line, fmt::format("the last {} intensities are missing: 0 is taken", missing));
    values.number.resize(whole, 0.0);
    values.line.resize(whole, last_line);
  }
  const auto all = take_angles(source, values, 0, planes, "C");
  const auto gamma = take_angles(source, values, planes, counts.gammas, "gamma");
  Planes found;
  found.horizontal = counts.symmetry == 1 ? std::vector<double>{0.0}
                                          : stored_angles(source, counts, all, first_line + planes - 1);
  std::size_t negative = 0;
  for (auto i = planes + counts.gammas; i < planes + counts.gammas + intensities; ++i) {
    if (values.number[i] < 0.0) ++negative;
    found.candela.push_back(std::max(0.0, values.number[i]) * counts.factor * flux / 1000.0);
  }
  if (negative > 0) source.warn(last_line, fmt::format("{} negative intensities are taken as 0", negative));
  try {
    if (const auto warning = standardise(found); !warning.empty()) source.warn(first_line, warning);
    source.result.intensity = {GoniometerType::c, gamma, std::move(found.horizontal),
                               std::move(found.candela)};
  } catch (const InputError& error) {
    throw InputError(source.file, first_line, error.what());
  }
}

}  // namespace

bool is_eulumdat(const std::vector<std::string_view>& lines) {
  if (lines.size() < 6) return false;
  for (const std::size_t line : {2, 3, 4, 6})
    if (without_blanks(lines[line - 1]).empty() || !decimal_of(lines[line - 1])) return false;
  return true;
}

void read_eulumdat(PhotometrySource& source, const PhotometryOptions& options) {
  const HeaderLines header(source);
  read_names(source, header);
  const auto counts = read_counts(source, header);
  read_opening(source, header);
  read_lamps(source, header, counts, options);
  const auto flux = find_flux(source);
  read_intensity(source, counts, flux);
  source.result.header_flux = header.number(23, "the light output ratio") / 100.0 * flux;
}

}  // namespace luxel
