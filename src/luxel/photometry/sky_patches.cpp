// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/sky_patches.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "luxel/core/trig.h"

namespace luxel {
namespace {

constexpr std::array<std::size_t, 7> tregenza_columns = {30, 30, 24, 24, 18, 12, 6};

double squared(double x) { return x * x; }

}  // namespace

SkyPatches::SkyPatches(int subdivision, const Vec3d& zenith, const Vec3d& north, LowerHalf lower)
    : subdivision_(subdivision),
      lower_(lower),
      zenith_(zenith),
      north_(north),
      east_(glm::cross(north, zenith)) {
  assert(subdivision >= 0 && subdivision <= 16);
  const auto split = static_cast<std::size_t>(subdivision);
  const auto rows = tregenza_columns.size() * split;
  const auto height = 0.5 * std::numbers::pi / (static_cast<double>(rows) + 0.5);
  row_begins_.push_back(0);
  for (std::size_t row = 0; row <= rows; ++row) {
    sine_.push_back(sin_cos(static_cast<double>(row) * height).sine);
    const auto columns = row < rows ? tregenza_columns[row / split] * split : 1;
    row_begins_.push_back(row_begins_.back() + columns);
  }
  sine_.push_back(1.0);
  size_ = 1 + (lower == LowerHalf::mirrored ? 2 : 1) * row_begins_.back();
}

Vec3d SkyPatches::in_local_axes(const Vec3d& direction) const {
  return {glm::dot(direction, east_), glm::dot(direction, north_), glm::dot(direction, zenith_)};
}

Vec3d SkyPatches::in_scene_axes(const Vec3d& local) const {
  return local.x * east_ + local.y * north_ + local.z * zenith_;
}

std::size_t SkyPatches::patch_of(const Vec3d& direction) const {
  if (is_one()) return 0;
  const auto local = in_local_axes(direction);
  if (local.z < 0.0 && lower_ == LowerHalf::one) return 0;
  const auto sine = std::fabs(local.z);
  const auto row =
      static_cast<std::size_t>(std::upper_bound(sine_.begin() + 1, sine_.end() - 1, sine) - sine_.begin()) -
      1;
  const auto columns = row_begins_[row + 1] - row_begins_[row];
  const auto turns = std::atan2(local.x, local.y) / (2.0 * std::numbers::pi) + 1.0;  // from north to the east
  const auto column = static_cast<std::size_t>(turns * static_cast<double>(columns) + 0.5) % columns;
  return 1 + row_begins_[row] + column + (local.z < 0.0 ? row_begins_.back() : 0);
}

std::array<SkyPatches::Weighted, 4> SkyPatches::around(const Vec3d& direction) const {
  std::array<Weighted, 4> found{};
  const auto local = in_local_axes(direction);
  if (is_one() || (local.z < 0.0 && lower_ == LowerHalf::one)) {
    found[0].weight = 1.0;
    return found;
  }
  const auto rows = row_begins_.size() - 1;
  const auto height = 0.5 * std::numbers::pi / (static_cast<double>(rows) - 0.5);
  const auto elevation = std::asin(std::min(1.0, std::fabs(local.z)));
  const auto row_at = std::clamp(elevation / height - 0.5, 0.0, static_cast<double>(rows - 1));
  const auto turns = std::atan2(local.x, local.y) / (2.0 * std::numbers::pi) + 1.0;
  const auto first_row = std::min(static_cast<std::size_t>(row_at), rows - 1);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto row = std::min(first_row + i, rows - 1);
    const auto of_row = row_at - static_cast<double>(first_row);
    const auto columns = row_begins_[row + 1] - row_begins_[row];
    const auto column_at = turns * static_cast<double>(columns);
    const auto column = static_cast<std::size_t>(column_at);
    const auto of_column = column_at - static_cast<double>(column);
    const auto begin = 1 + row_begins_[row] + (local.z < 0.0 ? row_begins_.back() : 0);
    const auto weight = i == 0 ? 1.0 - of_row : of_row;
    found[2 * i] = {begin + column % columns, weight * (1.0 - of_column)};
    found[2 * i + 1] = {begin + (column + 1) % columns, weight * of_column};
  }
  return found;
}

SkyPatches::Place SkyPatches::place_of(std::size_t patch) const {
  Place place;
  auto index = patch - 1;
  if (index >= row_begins_.back()) {
    place.is_below = true;
    index -= row_begins_.back();
  }
  const auto end = std::upper_bound(row_begins_.begin(), row_begins_.end(), index);
  place.row = static_cast<std::size_t>(end - row_begins_.begin()) - 1;
  place.columns = row_begins_[place.row + 1] - row_begins_[place.row];
  place.column = index - row_begins_[place.row];
  return place;
}

double SkyPatches::solid_angle(std::size_t patch) const {
  assert(patch < size());
  if (is_one()) return 4.0 * std::numbers::pi;
  if (patch == 0) return lower_ == LowerHalf::one ? 2.0 * std::numbers::pi : 0.0;
  const auto place = place_of(patch);
  return 2.0 * std::numbers::pi * (sine_[place.row + 1] - sine_[place.row]) /
         static_cast<double>(place.columns);
}

double SkyPatches::projected_solid_angle(std::size_t patch) const {
  assert(patch < size());
  if (is_one()) return 0.0;
  if (patch == 0) return lower_ == LowerHalf::one ? -std::numbers::pi : 0.0;
  const auto place = place_of(patch);
  const auto whole = std::numbers::pi * (squared(sine_[place.row + 1]) - squared(sine_[place.row]));
  return (place.is_below ? -whole : whole) / static_cast<double>(place.columns);
}

Vec3d SkyPatches::direction(std::size_t patch, const std::array<double, 2>& u) const {
  assert(patch < size());
  const auto local = [](double height, double azimuth) {
    const auto radius = std::sqrt(std::max(0.0, 1.0 - height * height));
    const auto turn = sin_cos(azimuth);
    return Vec3d(radius * turn.sine, radius * turn.cosine, height);
  };
  if (is_one()) return in_scene_axes(local(2.0 * u[0] - 1.0, 2.0 * std::numbers::pi * u[1]));
  if (patch == 0) {
    const auto height = lower_ == LowerHalf::one ? u[0] - 1.0 : -1.0;
    return in_scene_axes(local(height, 2.0 * std::numbers::pi * u[1]));
  }
  const auto place = place_of(patch);
  const auto height = sine_[place.row] + u[0] * (sine_[place.row + 1] - sine_[place.row]);
  const auto azimuth = 2.0 * std::numbers::pi * (static_cast<double>(place.column) + u[1] - 0.5) /
                       static_cast<double>(place.columns);
  const bool is_cap = place.columns == 1;
  return in_scene_axes(
      local((place.is_below ? -1.0 : 1.0) * (is_cap && u[0] == 0.5 && u[1] == 0.5 ? 1.0 : height), azimuth));
}

}  // namespace luxel
