// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/ies_tilt.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "luxel/core/output_file.h"

namespace luxel {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_tilt_angles = 10'000;
constexpr std::uint64_t max_tilt_bytes = 1 << 20;

// Orientation of the lamp in the luminaire.
enum class LampGeometry { vertical = 1, horizontal_staying = 2, horizontal_tilting = 3 };

struct TiltFactors {
  LampGeometry geometry = LampGeometry::vertical;
  std::vector<double> angles;   // degrees, ascending
  std::vector<double> factors;  // of the lamp's flux, per angle
};

TiltFactors read_factors(const std::string& file, Numbers& numbers) {
  TiltFactors tilt;
  tilt.geometry = static_cast<LampGeometry>(numbers.next_count("the lamp's geometry in the luminaire", 1, 3));
  const auto count = numbers.next_count("the number of tilt angles", 1, max_tilt_angles);
  tilt.angles = read_angles(numbers, file, count, "tilt");
  for (std::size_t i = 0; i < count; ++i)
    tilt.factors.push_back(std::max(0.0, numbers.next("a tilt factor")));
  return tilt;
}

double untilted(const TiltFactors& tilt) {
  const auto& a = tilt.angles;
  const auto next = static_cast<std::size_t>(std::lower_bound(a.begin(), a.end(), 0.0) - a.begin());
  if (next == 0) return tilt.factors.front();
  if (next == a.size()) return tilt.factors.back();
  const auto place = (0.0 - a[next - 1]) / (a[next] - a[next - 1]);
  return tilt.factors[next - 1] + place * (tilt.factors[next] - tilt.factors[next - 1]);
}

// Reports how the factors are used. Returns the factor to apply.
double apply(PhotometrySource& source, std::size_t line, const TiltFactors& tilt) {
  auto factor = untilted(tilt);
  if (!(factor > 0.0)) factor = 1.0;
  const auto [low, high] = std::minmax_element(tilt.factors.begin(), tilt.factors.end());
  const auto where = tilt.geometry == LampGeometry::vertical ? "the lamp is vertical"
                     : tilt.geometry == LampGeometry::horizontal_staying
                         ? "the lamp is horizontal and stays so"
                         : "the lamp is horizontal and tilts with the luminaire";
  source.warn(
      line,
      fmt::format("tilt factors of {:g} to {:g} for a luminaire tilted by {:g} to {:g} degrees ({}): the "
                  "factor without tilt, {:g}, is applied; multiply a tilted luminaire's dimming by its own",
                  *low, *high, tilt.angles.front(), tilt.angles.back(), where, factor));
  return factor;
}

double read_tilt_file(PhotometrySource& source, std::size_t line, std::string_view name) {
  // Only the name counts, not a path on another machine.
  const auto slash = name.find_last_of("/\\");
  const auto base = std::string(slash == name.npos ? name : name.substr(slash + 1));
  const auto path = fs::path(source.file).parent_path() / base;
  std::error_code error;
  if (base.empty() || base.find('\0') != base.npos || !fs::is_regular_file(path, error)) {
    source.warn(line,
                fmt::format("the tilt file '{}' is not in the folder of this file: no tilt factor is applied",
                            excerpt_of(name)));
    return 1.0;
  }
  const auto bytes = read_file(path, max_tilt_bytes);
  const auto file = path.string();
  const auto lines = split_lines(bytes);
  Numbers numbers(file, lines, 0);
  return apply(source, line, read_factors(file, numbers));
}

}  // namespace

double read_tilt(PhotometrySource& source, std::size_t line, int version, Numbers& numbers) {
  const auto text = source.lines[line];
  const auto value = without_blanks(text.substr(text.find('=') + 1));
  const auto upper = upper_case(value.substr(0, 256));
  if (upper == "NONE") return 1.0;
  if (upper == "INCLUDE") return apply(source, line + 1, read_factors(source.file, numbers));
  if (value.empty()) {
    source.warn(line + 1, "TILT= names nothing: TILT=NONE is taken");
    return 1.0;
  }
  if (version >= 2019)
    source.warn(line + 1, "LM-63-2019 has no tilt files: it is read as in earlier versions");
  return read_tilt_file(source, line + 1, value);
}

}  // namespace luxel
