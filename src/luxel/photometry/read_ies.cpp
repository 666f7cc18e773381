// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/read_ies.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/photometry/ies_opening.h"
#include "luxel/photometry/ies_tilt.h"
#include "luxel/photometry/planes.h"

namespace luxel {
namespace {

constexpr double metres_per_foot = 0.3048;

// The first ten values of the photometric data, and the three after them.
struct Header {
  double lamps = 0.0, lumens = 0.0, multiplier = 0.0;
  std::size_t verticals = 0, horizontals = 0;
  GoniometerType type = GoniometerType::c;
  Vec3d width_length_height = Vec3d(0.0);  // m
  double factor = 1.0;                     // of the candela: multiplier, ballast and ballast-lamp factor
  double watts = 0.0;
  std::size_t counts_line = 0, size_line = 0;
};

// TILT=, which some files write [TILT]=.
bool is_tilt(std::string_view line) {
  const auto text = upper_case(without_blanks(line.substr(0, 256)));
  const auto name = without_blanks(std::string_view(text).substr(0, text.find('=')));
  return name.size() < text.size() && (name == "TILT" || name == "[TILT]");
}

std::optional<std::size_t> find_tilt(const std::vector<std::string_view>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (is_tilt(lines[i])) return i;
  return std::nullopt;
}

std::optional<std::size_t> first_filled(const std::vector<std::string_view>& lines) {
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (!without_blanks(lines[i]).empty()) return i;
  return std::nullopt;
}

// The last number in a text, such as 1995 in "IESNA:LM-63-1995"; -1: none.
int last_number(std::string_view text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  auto end = text.size();
  while (end > 0 && !is_digit(text[end - 1])) --end;
  auto first = end;
  while (first > 0 && is_digit(text[first - 1]) && end - first < 4) --first;
  return end == first ? -1 : std::atoi(std::string(text.substr(first, end - first)).c_str());
}

bool has_tag(std::string_view line) {
  return upper_case(without_blanks(line.substr(0, 80))).starts_with("IES");
}

// The version of the standard that a tag names. The standard's own tags are exact; others are read by the
// year.
int read_version(PhotometrySource& source, std::size_t line) {
  if (!has_tag(source.lines[line])) return 1986;
  const auto tag = upper_case(without_blanks(source.lines[line].substr(0, 80)));
  for (const auto& [name, year] : {std::pair("IESNA91", 1991), std::pair("IESNA:LM-63-1995", 1995),
                                   std::pair("IESNA:LM-63-2002", 2002), std::pair("IES:LM-63-2019", 2019)})
    if (tag == name) return year;
  auto year = last_number(tag);
  if (year >= 0 && year < 100) year += year < 50 ? 2000 : 1900;
  const auto version = year < 1986   ? 2002
                       : year < 1991 ? 1986
                       : year < 1995 ? 1991
                       : year < 2002 ? 1995
                       : year < 2019 ? 2002
                                     : 2019;
  source.warn(line + 1, fmt::format("'{}' names no version of LM-63: the rules of {} are used",
                                    excerpt_of(tag), version));
  return version;
}

// [KEYWORD] text; [MORE] continues the one before.
void read_labels(PhotometrySource& source, std::size_t first, std::size_t end, LampSet& lamp) {
  auto& result = source.result;
  std::string* last = nullptr;
  for (auto i = first; i < end; ++i) {
    const auto line = without_blanks(source.lines[i]);
    const auto close = line.find(']');
    if (!line.starts_with('[') || close == line.npos) {
      // 1986 has free text only, whose first line names the luminaire.
      if (result.format == "IES LM-63-1986" && result.luminaire.empty() && !line.starts_with('['))
        result.luminaire = name_of(line);
      continue;
    }
    const auto keyword = upper_case(without_blanks(line.substr(1, close - 1)));
    const auto text = name_of(line.substr(close + 1));
    if (keyword == "MORE") {
      if (last && !text.empty()) *last += (last->empty() ? "" : " ") + text;
      continue;
    }
    last = keyword == "LUMINAIRE" ? &result.luminaire
           : keyword == "LUMCAT"  ? &result.catalogue
           : keyword == "MANUFAC" ? &result.maker
           : keyword == "TEST"    ? &result.test_report
           : keyword == "LAMP"    ? &lamp.name
                                  : nullptr;
    // In a file with several, the first one counts.
    if (last && last->empty())
      *last = text;
    else
      last = nullptr;
  }
}

double read_factor(PhotometrySource& source, Numbers& numbers, std::string_view what) {
  const auto value = numbers.next(what);
  if (value < 0.0)
    throw InputError(source.file, numbers.line(),
                     fmt::format("expected {} above 0, found {:g}", what, value));
  if (value > 0.0) return value;
  source.warn(numbers.line(), fmt::format("{} is 0, which would leave no light: 1 is taken", what));
  return 1.0;
}

void read_counts(PhotometrySource& source, Numbers& numbers, Header& header) {
  header.lamps = numbers.next("the number of lamps");
  header.counts_line = numbers.line();
  if (!(header.lamps > 0.0)) {
    source.warn(numbers.line(), fmt::format("the number of lamps is {:g}: 1 is taken", header.lamps));
    header.lamps = 1.0;
  }
  header.lumens = numbers.next("the lumens per lamp");
  header.multiplier = read_factor(source, numbers, "the candela multiplier");
  header.verticals = numbers.next_count("the number of vertical angles", 1, max_intensities);
  header.horizontals = numbers.next_count("the number of horizontal angles", 1, max_intensities);
  if (header.verticals * header.horizontals > max_intensities)
    throw InputError(source.file, numbers.line(),
                     fmt::format("expected at most {} values of candela, found {} x {}", max_intensities,
                                 header.horizontals, header.verticals));
  const auto type = numbers.next_count("the photometric type", 1, 3);
  header.type = type == 1 ? GoniometerType::c : type == 2 ? GoniometerType::b : GoniometerType::a;
  const auto metres =
      numbers.next_count("the units, 1 for feet or 2 for metres,", 1, 2) == 1 ? metres_per_foot : 1.0;
  for (int i = 0; i < 3; ++i) {
    constexpr const char* sizes[] = {"the opening's width", "the opening's length", "the opening's height"};
    header.width_length_height[i] = metres * numbers.next(sizes[i]);
  }
  header.size_line = numbers.line();
}

Header read_header(PhotometrySource& source, Numbers& numbers, int version) {
  Header header;
  read_counts(source, numbers, header);
  header.factor = header.multiplier * read_factor(source, numbers, "the ballast factor");
  // The ballast-lamp photometric factor until 1991, unused from 1995 on, a code of the file's origin in 2019.
  if (version < 1995)
    header.factor *= read_factor(source, numbers, "the ballast-lamp factor");
  else
    numbers.next("the field after the ballast factor");
  header.watts = std::max(0.0, numbers.next("the input watts"));
  return header;
}

void read_opening(PhotometrySource& source, const Header& header, int version) {
  bool is_other = false;
  const auto& size = header.width_length_height;
  const auto opening = opening_of(version, header.type, size, is_other);
  const auto sizes = fmt::format("width {:g}, length {:g}, height {:g} m", size.x, size.y, size.z);
  if (!opening)
    return source.warn(header.size_line,
                       fmt::format("the signs of {} stand for no luminous opening: a point is taken", sizes));
  source.result.opening = *opening;
  const bool is_lone_width = size.x < 0.0 && size.y == 0.0 && size.z == 0.0;
  if (is_lone_width && version >= 2002)
    source.warn(header.size_line, fmt::format("{} follow the signs before 2002: a disk is taken", sizes));
  else if (is_other)
    source.warn(header.size_line,
                fmt::format("the signs of {} are of another version than {}", sizes, source.result.format));
}

// Type 1 of a 1986 file was C and A; only A has vertical angles below 0.
void find_type(PhotometrySource& source, Header& header, int version, double lowest, std::size_t line) {
  if (header.type != GoniometerType::c || lowest >= 0.0) return;
  if (version != 1986)
    throw InputError(source.file, line,
                     fmt::format("expected vertical angles from 0 on in type C, found {:g}", lowest));
  header.type = GoniometerType::a;
  source.warn(line, "vertical angles below 0 in type 1 of 1986: type A is taken");
}

std::vector<double> read_candela(PhotometrySource& source, Numbers& numbers, const Header& header) {
  std::vector<double> candela;
  std::size_t negative = 0, line = 0;
  for (std::size_t h = 0; h < header.horizontals; ++h)
    for (std::size_t v = 0; v < header.verticals; ++v) {
      auto value = numbers.next("candela");
      if (value < 0.0) {
        if (negative++ == 0) line = numbers.line();
        value = 0.0;
      }
      candela.push_back(value * header.factor);
    }
  if (negative > 0) source.warn(line, fmt::format("{} negative values of candela are taken as 0", negative));
  if (!numbers.at_end())
    source.warn(numbers.line(), fmt::format("more follows after {} x {} values of candela, and is not read",
                                            header.horizontals, header.verticals));
  return candela;
}

void check_ranges(PhotometrySource& source, GoniometerType type, const std::vector<double>& vertical,
                  std::size_t line) {
  const auto first = vertical.front(), last = vertical.back();
  if (type != GoniometerType::c) {
    if (first >= 0.0)
      source.warn(line,
                  fmt::format("vertical angles {:g} to {:g} are taken as mirrored below 0", first, last));
    return;
  }
  const bool begins = first == 0.0 || first == 90.0, ends = last == 90.0 || last == 180.0;
  if (!begins || !ends)
    source.warn(
        line, fmt::format("vertical angles {:g} to {:g} do not cover 0 to 90, 90 to 180 or 0 to 180 degrees: "
                          "intensity beyond them is 0",
                          first, last));
}

void read_intensity(PhotometrySource& source, Numbers& numbers, Header& header, int version,
                    double tilt_factor) {
  const auto vertical = read_angles(numbers, source.file, header.verticals, "vertical");
  const auto vertical_line = numbers.line();
  find_type(source, header, version, vertical.front(), vertical_line);
  check_ranges(source, header.type, vertical, vertical_line);
  Planes planes;
  planes.horizontal = read_angles(numbers, source.file, header.horizontals, "horizontal");
  const auto horizontal_line = numbers.line();
  header.factor *= tilt_factor;
  planes.candela = read_candela(source, numbers, header);
  try {
    if (header.type == GoniometerType::c)
      if (const auto warning = standardise(planes); !warning.empty()) source.warn(horizontal_line, warning);
    source.result.intensity = {header.type, vertical, std::move(planes.horizontal),
                               std::move(planes.candela)};
  } catch (const InputError& error) {
    throw InputError(source.file, horizontal_line, error.what());
  }
}

}  // namespace

bool is_ies(const std::vector<std::string_view>& lines) {
  const auto first = first_filled(lines);
  if (!first) return false;
  return has_tag(lines[*first]) || find_tilt(lines);
}

void read_ies(PhotometrySource& source) {
  auto& result = source.result;
  const auto first = first_filled(source.lines).value_or(0);
  const auto tilt = find_tilt(source.lines);
  if (!tilt)
    throw InputError(source.file, source.lines.size(), "expected a line TILT= before the photometric data");
  const auto version = read_version(source, first);
  result.format = fmt::format("IES LM-63-{}", version);
  LampSet lamp;
  read_labels(source, has_tag(source.lines[first]) ? first + 1 : first, *tilt, lamp);
  Numbers numbers(source.file, source.lines, *tilt + 1);
  const auto tilt_factor = read_tilt(source, *tilt, version, numbers);
  auto header = read_header(source, numbers, version);
  result.absolute = header.lumens <= 0.0;
  if (header.lumens == 0.0)
    source.warn(header.counts_line, "lumens per lamp is 0: candela are taken as absolute");
  lamp.count = header.lamps;
  lamp.flux = result.absolute ? 0.0 : header.lamps * header.lumens;
  lamp.watts = header.watts;
  result.lamps.push_back(std::move(lamp));
  read_intensity(source, numbers, header, version, tilt_factor);
  read_opening(source, header, version);
}

}  // namespace luxel
