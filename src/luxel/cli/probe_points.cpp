// SPDX-License-Identifier: Apache-2.0
#include "luxel/cli/probe_points.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/import/csv_table.h"
#include "luxel/import/numbers.h"
#include "luxel/import/text.h"
#include "luxel/runs/option_set.h"

namespace luxel {
namespace {

constexpr std::array<std::string_view, 6> names = {"x", "y", "z", "nx", "ny", "nz"};

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto end = text.find(separator);
    parts.push_back(trim(text.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) return std::nullopt;
  return value;
}

class PointReader {
 public:
  PointReader(const std::string& file, const Vec3d& normal) : file_(file), normal_(normal) {}

  PointList read() {
    const auto text = read_text(file_, file_);
    Statements lines(text);
    while (lines.next()) {
      line_ = lines.line();
      const auto content = trim(lines.text());
      if (!content.empty() && content.front() != '#') take(content);
    }
    if (points_.position.empty())
      throw InputError(file_, "expected points, x,y,z or x,y,z,nx,ny,nz on each line, found none");
    return std::move(points_);
  }

 private:
  [[noreturn]] void refuse(const std::string& sentence) const { throw InputError(file_, line_, sentence); }

  void take(std::string_view content) {
    const auto fields = csv_fields(content, ',', [this](const std::string& sentence) { refuse(sentence); });
    const bool is_first = !std::exchange(has_begun_, true);
    const bool has_names =
        std::any_of(fields.begin(), fields.end(), [](const auto& f) { return is_a_name(f); });
    if (is_first && has_names) return take_names(fields, content);
    if (is_first) take_columns(fields.size(), content);
    if (fields.size() != fields_)
      refuse(
          fmt::format("expected {} fields as before, separated by commas, found {}", fields_, fields.size()));
    add(fields);
  }

  static bool is_a_name(std::string_view field) {
    return !field.empty() && std::isalpha(static_cast<unsigned char>(field.front())) != 0 &&
           lower_case(field) != "nan" && lower_case(field) != "inf" && lower_case(field) != "infinity";
  }

  void take_names(const std::vector<std::string>& fields, std::string_view content) {
    fields_ = fields.size();
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto found = std::find_if(fields.begin(), fields.end(),
                                      [&](std::string_view f) { return lower_case(f) == names[k]; });
      if (found != fields.end()) column_[k] = static_cast<std::size_t>(found - fields.begin());
    }
    const auto named = [&](std::size_t k) { return column_[k].has_value(); };
    if (!named(0) || !named(1) || !named(2))
      refuse(fmt::format("expected the columns x, y and z (and nx, ny, nz), separated by commas, found '{}'",
                         excerpt(content)));
    if (named(3) != named(4) || named(3) != named(5))
      refuse("expected all of the columns nx, ny and nz, or none of them");
  }

  void take_columns(std::size_t count, std::string_view content) {
    if (count != 3 && count != 6)
      refuse(fmt::format("expected 3 or 6 numbers (x,y,z or x,y,z,nx,ny,nz), separated by commas, found '{}'",
                         excerpt(content)));
    fields_ = count;
    for (std::size_t k = 0; k < count; ++k) column_[k] = k;
  }

  double number(const std::vector<std::string>& fields, std::size_t k) const {
    const auto field = fields[*column_[k]];
    const auto value = read_precise_number(field);
    if (!value) refuse(fmt::format("expected a finite number for {}, found '{}'", names[k], excerpt(field)));
    return *value;
  }

  void add(const std::vector<std::string>& fields) {
    const Vec3d at(number(fields, 0), number(fields, 1), number(fields, 2));
    auto normal = normal_;
    if (column_[3]) {
      normal = {number(fields, 3), number(fields, 4), number(fields, 5)};
      if (!(glm::length(normal) > 0.0)) refuse("expected a normal that is not 0,0,0");
      normal = glm::normalize(normal);
    }
    if (points_.position.size() == max_points) refuse(fmt::format("expected at most {} points", max_points));
    points_.add(at, normal);
  }

  std::string file_;
  Vec3d normal_;
  PointList points_;
  std::size_t line_ = 0;
  bool has_begun_ = false;
  std::size_t fields_ = 0;
  std::array<std::optional<std::size_t>, 6> column_;
};

}  // namespace

PointList read_points(const std::string& file, const Vec3d& normal) {
  return PointReader(file, normal).read();
}

std::optional<PointLine> parse_line(const std::string& text) {
  const auto parts = parts_of(text, ':');
  if (parts.size() != 3) return std::nullopt;
  const auto from = parse_three(std::string(parts[0])), to = parse_three(std::string(parts[1]));
  const auto count = whole_number(parts[2]);
  if (!from || !to || !count || *count < 2 || *count > max_points) return std::nullopt;
  return PointLine{*from, *to, *count};
}

PointList points_of(const PointLine& line, const Vec3d& normal) {
  PointList points;
  for (std::size_t i = 0; i < line.count; ++i) {
    const auto t = static_cast<double>(i) / static_cast<double>(line.count - 1);
    points.add((1.0 - t) * line.from + t * line.to, normal);
  }
  return points;
}

std::optional<PointGrid> parse_grid(const std::string& text) {
  const auto parts = parts_of(text, ':');
  if (parts.size() != 4) return std::nullopt;
  const auto corner = parse_three(std::string(parts[0])), first = parse_three(std::string(parts[1])),
             second = parse_three(std::string(parts[2]));
  const auto counts = parts_of(parts[3], 'x');
  if (!corner || !first || !second || counts.size() != 2) return std::nullopt;
  const auto columns = whole_number(counts[0]), rows = whole_number(counts[1]);
  if (!columns || !rows || *columns < 1 || *rows < 1 || *columns > max_points ||
      *rows > max_points / *columns)
    return std::nullopt;
  if (!(glm::length(glm::cross(*first - *corner, *second - *corner)) > 0.0)) return std::nullopt;
  return PointGrid{*corner, *first, *second, *columns, *rows};
}

PointList points_of(const PointGrid& grid, const std::optional<Vec3d>& normal) {
  const auto along = grid.first - grid.corner, across = grid.second - grid.corner;
  const auto towards = normal ? *normal : glm::normalize(glm::cross(along, across));
  PointList points;
  points.columns = grid.columns;
  for (std::size_t j = 0; j < grid.rows; ++j)
    for (std::size_t i = 0; i < grid.columns; ++i)
      points.add(grid.corner + (static_cast<double>(i) + 0.5) / static_cast<double>(grid.columns) * along +
                     (static_cast<double>(j) + 0.5) / static_cast<double>(grid.rows) * across,
                 towards);
  return points;
}

}  // namespace luxel
