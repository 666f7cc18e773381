// SPDX-License-Identifier: Apache-2.0
#include "luxel/photometry/sky_integrals.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "luxel/core/error.h"
#include "luxel/core/trig.h"

namespace luxel {
namespace {

constexpr double exact_pi = std::numbers::pi;

// Between two elevations and two azimuths, rad; azimuths from north to the east.
struct Cell {
  double low, high, begin, end;
};

// Gauss-Legendre of four points on [-1, 1].
constexpr std::array<double, 4> nodes = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                         0.8611363115940526};
constexpr std::array<double, 4> weights = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                           0.3478548451374538};

// Cells are cut until they are no larger than these, rad. The luminance has a cusp at the sun; with cells of
// 0.3 degrees there, the integral over the sky of type 15 is off by 2e-8 (measured).
constexpr double max_azimuths = exact_pi / 3.0;
constexpr double max_at_horizon = 3.0 * exact_pi / 180.0;
constexpr double max_at_sun = 0.3 * exact_pi / 180.0;

// The formulas are not analytic at the horizon (exp(b / sine)) and have a cusp at the sun.
enum class Cut { none, elevations, azimuths, both };

Cut cut_of(const SkyModel& model, const Cell& cell) {
  if (cell.end - cell.begin > max_azimuths) return Cut::azimuths;
  const auto height = cell.high - cell.low;
  if (height > std::max(max_at_horizon, cell.low)) return Cut::elevations;
  if (!model.follows_sun()) return Cut::none;
  const auto middle = sin_cos(0.5 * (cell.low + cell.high)), turn = sin_cos(0.5 * (cell.begin + cell.end));
  const auto width = (cell.end - cell.begin) * sin_cos(cell.low).cosine;
  const auto size = std::max(height, width);
  if (size <= max_at_sun) return Cut::none;
  const Vec3d centre(middle.cosine * turn.sine, middle.cosine * turn.cosine, middle.sine);
  const auto distance = arc_cosine(glm::dot(centre, model.sun())) - 0.5 * std::hypot(height, width);
  if (distance > size) return Cut::none;
  return height > 2.0 * width ? Cut::elevations : width > 2.0 * height ? Cut::azimuths : Cut::both;
}

// Calls add(direction, L * solid angle) for points of the cell whose sum is the integral over it.
template <typename Add>
void integrate(const SkyModel& model, const Cell& cell, const Add& add) {
  const auto cut = cut_of(model, cell);
  if (cut != Cut::none) {
    const auto half_way = 0.5 * (cell.low + cell.high), half_turn = 0.5 * (cell.begin + cell.end);
    const bool by_elevation = cut != Cut::azimuths, by_azimuth = cut != Cut::elevations;
    for (int i = 0; i <= (by_elevation ? 1 : 0); ++i)
      for (int j = 0; j <= (by_azimuth ? 1 : 0); ++j)
        integrate(model,
                  Cell{i == 0 ? cell.low : half_way, i == 0 && by_elevation ? half_way : cell.high,
                       j == 0 ? cell.begin : half_turn, j == 0 && by_azimuth ? half_turn : cell.end},
                  add);
    return;
  }
  const auto height = 0.5 * (cell.high - cell.low), width = 0.5 * (cell.end - cell.begin);
  std::array<SinCos, nodes.size()> turns;
  for (std::size_t j = 0; j < nodes.size(); ++j) turns[j] = sin_cos(cell.begin + width * (1.0 + nodes[j]));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto elevation = sin_cos(cell.low + height * (1.0 + nodes[i]));
    const auto weight = weights[i] * height * width * elevation.cosine;
    for (std::size_t j = 0; j < nodes.size(); ++j) {
      const Vec3d direction(elevation.cosine * turns[j].sine, elevation.cosine * turns[j].cosine,
                            elevation.sine);
      add(direction, weight * weights[j] * model.relative_luminance(direction));
    }
  }
}

// The patch's elevations and azimuths. Not for patch 0.
Cell cell_of(const SkyPatches& patches, std::size_t patch) {
  const auto first = patches.in_local_axes(patches.direction(patch, {0.0, 0.5}));
  const auto last = patches.in_local_axes(patches.direction(patch, {1.0, 0.5}));
  const auto middle = std::atan2(first.x, first.y);
  const auto elevation = [](double sine) { return std::asin(std::clamp(sine, 0.0, 1.0)); };
  const auto half = 0.5 * patches.solid_angle(patch) / (last.z - first.z);
  return {elevation(first.z), elevation(last.z), middle - half, middle + half};
}

}  // namespace

SkyIlluminances relative_illuminances(const SkyModel& model) {
  // Quarters begin at north, east, south and west, so that no cell lies before and behind a vertical plane.
  constexpr int rows = 6, columns = 24;
  SkyIlluminances sum;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const auto height = 0.5 * exact_pi / rows, width = 2.0 * exact_pi / columns;
      integrate(model, Cell{row * height, (row + 1) * height, column * width, (column + 1) * width},
                [&sum](const Vec3d& direction, double light) {
                  sum.horizontal += light * direction.z;
                  sum.north += light * std::max(0.0, direction.y);
                  sum.east += light * std::max(0.0, direction.x);
                  sum.south += light * std::max(0.0, -direction.y);
                  sum.west += light * std::max(0.0, -direction.x);
                });
    }
  return sum;
}

double ground_luminance(double albedo, double horizontal_illuminance) {
  return albedo * horizontal_illuminance / exact_pi;
}

std::vector<double> sky_patch_luminances(const SkyModel& model, const SkyPatches& patches,
                                         const SkyLevel& level) {
  if (patches.is_one()) throw InputError("a sky model needs patches of the sky, not one of all directions");
  const auto ground = ground_luminance(level.ground_albedo,
                                       level.horizontal_illuminance + level.direct_horizontal_illuminance);
  std::vector<double> luminances(patches.size(), ground);
  double illuminance = 0.0;
  for (std::size_t p = 1; p <= patches.upper(); ++p) {
    double sum = 0.0;
    integrate(model, cell_of(patches, p), [&sum](const Vec3d&, double light) { sum += light; });
    luminances[p] = sum / patches.solid_angle(p);
    illuminance += luminances[p] * patches.projected_solid_angle(p);
  }
  if (!(illuminance > 0.0) && level.horizontal_illuminance > 0.0)
    throw InputError("the sky model is 0 in all directions and cannot give any illuminance");
  const auto scale = illuminance > 0.0 ? level.horizontal_illuminance / illuminance : 0.0;
  for (std::size_t p = 1; p <= patches.upper(); ++p) luminances[p] *= scale;
  return luminances;
}

std::vector<double> sky_patch_luminances(const SkyModel& model, const SkyPatches& patches,
                                         double horizontal_illuminance, double ground_albedo) {
  return sky_patch_luminances(model, patches, {horizontal_illuminance, 0.0, ground_albedo});
}

}  // namespace luxel
