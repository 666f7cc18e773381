// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/form_factors/view_factors_file.h"
#include "luxel/solution/hdf5_reader.h"
#include "luxel/solution/hdf5_writer.h"
#include "luxel/solution/places_file.h"
#include "luxel/solution/provenance_file.h"

namespace luxel {
namespace {

constexpr unsigned fast_deflate = 1;
const std::string group = "ViewFactors";
const std::string provenance_group = group + "/provenance";

std::string in_group(std::string_view name) { return fmt::format("{}/{}", group, name); }

template <typename T>
void add_flat(Hdf5Writer& file, std::string_view name, const std::vector<T>& values,
              const std::string& unit = {}) {
  file.add_array(in_group(name), flat_array(std::span<const T>(values)), unit);
}

std::string sink_error_name(std::size_t k) {
  return fmt::format("{}_standard_error", ViewFactors::sink_name[k]);
}

template <typename T>
bool all_in(const std::vector<T>& values, double low, double high) {
  for (const auto value : values)
    if (const auto x = static_cast<double>(value); !(x >= low && x <= high)) return false;
  return true;
}

void check(const Hdf5Reader& file, const ViewFactors& f) {
  constexpr double rounding = 1e-9;
  if (f.row_begin.front() != 0 || f.row_begin.back() != f.count())
    file.refuse_as_damaged("row_begin does not go from 0 to the number of factors");
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (f.row_begin[i] > f.row_begin[i + 1]) file.refuse_as_damaged("row_begin falls");
    for (auto at = f.row_begin[i]; at < f.row_begin[i + 1]; ++at)
      if (f.column[at] >= f.size() || (at > f.row_begin[i] && f.column[at] <= f.column[at - 1]))
        file.refuse_as_damaged("columns of a row do not rise, or name no element");
  }
  const auto huge = 1e300;
  bool is_good = all_in(f.area, 1e-300, huge) && all_in(f.factor, 0.0, 1.0 + rounding) &&
                 all_in(f.standard_error, 0.0, huge) && all_in(f.rays, 0.0, huge) &&
                 all_in(f.is_known, 0.0, 1.0);
  for (const auto& sink : f.sink)
    is_good = is_good && all_in(sink.factor, 0.0, 1.0 + rounding) && all_in(sink.standard_error, 0.0, huge);
  if (!is_good) file.refuse_as_damaged("an area, a factor or a standard error is no such number");
}

}  // namespace

void write_view_factors_hdf5(const std::filesystem::path& path, const ViewFactors& factors,
                             const ViewFactorsNote& note, bool is_compressed) {
  Hdf5Writer file(is_compressed ? fast_deflate : 0);
  std::string_view bytes;
  try {
    file.add_group(group);
    file.add_number(group, "format_version", view_factors_format_version);
    file.add_word(group, "between", note.between);
    file.add_word(group, "sides", note.sides);
    file.add_number(group, "enforced", static_cast<std::uint8_t>(note.enforced ? 1 : 0));
    add_flat(file, "row_begin", factors.row_begin);
    add_flat(file, "column", factors.column);
    add_flat(file, "factor", factors.factor, "1");
    add_flat(file, "standard_error", factors.standard_error, "1");
    file.add_strings(in_group("name"), factors.name);
    add_flat(file, "area", factors.area, "m^2");
    add_flat(file, "rays", factors.rays);
    add_flat(file, "known", factors.is_known);
    for (std::size_t k = 0; k < ViewFactors::sinks; ++k) {
      add_flat(file, ViewFactors::sink_name[k], factors.sink[k].factor, "1");
      add_flat(file, sink_error_name(k), factors.sink[k].standard_error, "1");
    }
    if (!note.triangle.empty()) {
      add_flat(file, "triangle", note.triangle);
      add_places(file, in_group("centre"), note.centre, note.origin);
      add_origin(file, in_group("origin"), note.origin);
    }
    add_provenance(file, provenance_group, note.provenance);
    bytes = file.finish();
  } catch (const DeviceError& error) {
    throw cannot_write(path.string(), error.what());
  }
  write_file(path, bytes);
}

StoredViewFactors read_view_factors_hdf5(const std::filesystem::path& path) {
  const Hdf5Reader file(path);
  if (!file.has(group)) file.refuse("not view factors of Luxel (no ViewFactors group)");
  const auto version = file.number<std::uint32_t>(group, "format_version");
  if (version > view_factors_format_version)
    file.refuse(fmt::format("has format version {}, and this program reads up to {}: a newer Luxel is needed",
                            version, view_factors_format_version));
  const auto n = file.rows(in_group("area"));
  const auto count = file.rows(in_group("column"));
  StoredViewFactors stored;
  auto& f = stored.factors;
  f.name = file.strings(in_group("name"), n);
  f.area = file.array<double>(in_group("area"), n);
  f.rays = file.array<double>(in_group("rays"), n);
  f.is_known = file.array<std::uint8_t>(in_group("known"), n);
  f.row_begin = file.array<std::uint64_t>(in_group("row_begin"), n + 1);
  f.column = file.array<std::uint32_t>(in_group("column"), count);
  f.factor = file.array<double>(in_group("factor"), count);
  f.standard_error = file.array<float>(in_group("standard_error"), count);
  for (std::size_t k = 0; k < ViewFactors::sinks; ++k) {
    f.sink[k].factor = file.array<double>(in_group(ViewFactors::sink_name[k]), n);
    f.sink[k].standard_error = file.array<float>(in_group(sink_error_name(k)), n);
  }
  check(file, f);
  auto& note = stored.note;
  note.between = file.word(group, "between");
  note.sides = file.word(group, "sides");
  note.enforced = file.number<std::uint8_t>(group, "enforced") != 0;
  if (file.has(in_group("triangle"))) {
    note.triangle = file.array<std::uint32_t>(in_group("triangle"), n);
    note.origin = read_origin(file, in_group("origin"));
    note.centre = read_places(file, in_group("centre"), n, note.origin);
  }
  note.provenance = read_provenance(file, provenance_group);
  return stored;
}

}  // namespace luxel
