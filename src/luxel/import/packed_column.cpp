// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/packed_column.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "luxel/image/image.h"

namespace luxel {
namespace {

enum Component : int { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

struct Form {
  int component;
  bool is_normalised;
  bool needs_extension = false;
};

std::size_t size_of(int component) {
  return component == i8 || component == u8 ? 1 : component == i16 || component == u16 ? 2 : 4;
}

template <typename T>
void append(std::string& bytes, T value) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  bytes.append(raw.data(), raw.size());
}

// Returns the stored number for a value.
double stored(float value, const Form& form) {
  if (form.component == f32) return value;
  if (!form.is_normalised) return std::round(value);
  const auto bits = 8 * size_of(form.component);
  const bool has_sign = form.component == i8 || form.component == i16;
  return std::round(value * static_cast<double>((1 << (has_sign ? bits - 1 : bits)) - 1));
}

void append_stored(std::string& bytes, double number, int component) {
  switch (component) {
    case i8:
      return append(bytes, static_cast<std::int8_t>(number));
    case u8:
      return append(bytes, static_cast<std::uint8_t>(number));
    case i16:
      return append(bytes, static_cast<std::int16_t>(number));
    case u16:
      return append(bytes, static_cast<std::uint16_t>(number));
    case u32:
      return append(bytes, static_cast<std::uint32_t>(number));
    default:
      return append(bytes, static_cast<float>(number));
  }
}

// NaN is outside.
bool is_within(const GltfArray& array, float low) {
  for (std::size_t e = 0; e < array.size(); ++e) {
    const auto at = array.at(e);
    for (std::size_t c = 0; c < static_cast<std::size_t>(array.components()); ++c)
      if (!(at[c] >= low && at[c] <= 1.0f)) return false;
  }
  return true;
}

// Returns whether no displayed code changes by more than a half in 8 bits. Linear colours have too few steps
// in dark parts then.
bool fits_8_bits(const GltfArray& array, bool is_srgb) {
  if (is_srgb) return true;
  for (std::size_t e = 0; e < array.size(); ++e) {
    const auto at = array.at(e);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto rounded = std::round(255.0f * at[c]) / 255.0f;
      if (!(std::abs(srgb_encode(rounded) - srgb_encode(at[c])) <= 0.5f / 255.0f)) return false;
    }
  }
  return true;
}

Form form_of(std::string_view name, const GltfArray& array, const GltfPacking& packing) {
  const auto component = static_cast<int>(array.accessor()["componentType"].whole());
  const auto is_normalised = array.accessor()["normalized"].truth(false);
  const Form own = {component, is_normalised};
  if (name == "COLOR_0" && (component == u16 || (component == f32 && is_within(array, 0.0f))))
    return {fits_8_bits(array, packing.colours_are_srgb) ? u8 : u16, true};
  if (component != f32) return own;
  if (name.starts_with("TEXCOORD_") && is_within(array, 0.0f)) return {u16, true};
  if ((name == "NORMAL" || name == "TANGENT") && !packing.core_only && is_within(array, -1.0f))
    return {i8, true, true};
  return own;
}

// [component], of an element on the grid.
std::array<double, 4> on_grid(const std::array<float, 4>& at, const PositionGrid& grid) {
  const Vec3d position(at[0], at[1], at[2]);
  const auto p = grid.as_floats ? Vec3d(Vec3(grid.rounded(position))) : grid.index_of(position);
  return {p.x, p.y, p.z, 0.0};
}

}  // namespace

PackedColumn packed_column(std::string_view name, const GltfArray& array, const PositionGrid* grid,
                           const std::vector<std::uint32_t>& vertices, const GltfPacking& packing) {
  if (name != "POSITION") grid = nullptr;
  const auto form =
      grid ? Form{grid->as_floats ? f32 : u16, false, !grid->as_floats} : form_of(name, array, packing);
  const auto components = static_cast<std::size_t>(array.components());
  PackedColumn column;
  column.count = vertices.empty() ? array.size() : vertices.size();
  column.stride = (components * size_of(form.component) + 3) / 4 * 4;
  column.component = form.component;
  column.components = array.components();
  column.is_normalised = form.is_normalised;
  column.needs_extension = form.needs_extension;
  column.low.fill(std::numeric_limits<double>::infinity());
  column.high.fill(-std::numeric_limits<double>::infinity());
  column.bytes.reserve(column.count * column.stride);
  for (std::size_t i = 0; i < column.count; ++i) {
    const auto at = array.at(vertices.empty() ? i : vertices[i]);
    std::array<double, 4> numbers{};
    for (std::size_t c = 0; c < components; ++c) numbers[c] = stored(at[c], form);
    if (grid) numbers = on_grid(at, *grid);
    for (std::size_t c = 0; c < components; ++c) append_stored(column.bytes, numbers[c], form.component);
    for (std::size_t c = 0; c < 3; ++c) {
      column.low[c] = std::min(column.low[c], numbers[c]);
      column.high[c] = std::max(column.high[c], numbers[c]);
    }
    column.bytes.resize((i + 1) * column.stride);
  }
  return column;
}

}  // namespace luxel
