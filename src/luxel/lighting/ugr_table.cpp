// SPDX-License-Identifier: Apache-2.0
#include "luxel/lighting/ugr_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "luxel/core/error.h"
#include "luxel/core/trig.h"
#include "luxel/lighting/position_index.h"
#include "luxel/photometry/opening.h"

namespace luxel {
namespace {

constexpr double exact_pi = std::numbers::pi;
constexpr double height = 2.0;       // m, H
constexpr std::size_t zones = 18;    // of 10 degrees
constexpr double zone_width = 10.0;  // degrees

// Factors of four sums of zonal flux that give the flux which falls directly onto the plane of the eyes: CIE
// 190:2010, by the room index.
struct FloorFactors {
  double room_index;
  std::array<double, 4> factor;
};
constexpr std::array<FloorFactors, 13> floor_factors = {{{1.00, {0.690, 0.109, 0.085, -0.016}},
                                                         {1.20, {0.578, 0.200, 0.127, -0.018}},
                                                         {1.33, {0.528, 0.218, 0.170, -0.017}},
                                                         {1.50, {0.485, 0.215, 0.222, -0.012}},
                                                         {1.60, {0.466, 0.207, 0.249, -0.006}},
                                                         {1.71, {0.448, 0.198, 0.272, 0.005}},
                                                         {2.00, {0.338, 0.257, 0.351, -0.018}},
                                                         {2.40, {0.296, 0.203, 0.449, -0.006}},
                                                         {2.67, {0.280, 0.165, 0.499, 0.006}},
                                                         {3.00, {0.264, 0.125, 0.541, 0.027}},
                                                         {3.43, {0.248, 0.058, 0.628, 0.032}},
                                                         {4.00, {0.239, -0.012, 0.690, 0.058}},
                                                         {4.80, {0.232, -0.084, 0.740, 0.098}}}};

const FloorFactors& floor_factors_of(const UgrRoom& room) {
  const auto index = room.across * room.along / (room.across + room.along);
  return *std::min_element(floor_factors.begin(), floor_factors.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.room_index - index) < std::abs(b.room_index - index);
  });
}

// lm in zones of 10 degrees of gamma, from the intensity in their middles.
std::array<double, zones> zonal_fluxes(const IntensityDistribution& intensity) {
  constexpr int planes = 72;
  constexpr double radians = exact_pi / 180.0;
  std::array<double, zones> flux{};
  for (std::size_t z = 0; z < zones; ++z) {
    const auto gamma = sin_cos((static_cast<double>(z) + 0.5) * zone_width * radians);
    double mean = 0.0;
    for (int c = 0; c < planes; ++c) {
      const auto around = sin_cos(2.0 * exact_pi * c / planes);
      mean += intensity.at({gamma.sine * around.cosine, gamma.sine * around.sine, -gamma.cosine}) / planes;
    }
    flux[z] = 2.0 * exact_pi * gamma.sine * zone_width * radians * mean;
  }
  return flux;
}

// lm of one luminaire that fall directly onto the surfaces of a room.
struct DirectFlux {
  double floor = 0.0, wall = 0.0, ceiling = 0.0;
};

DirectFlux direct_flux(const std::array<double, zones>& flux, const UgrRoom& room) {
  const auto up_to = [&](std::size_t count) {
    double sum = 0.0;
    for (std::size_t z = 0; z < count; ++z) sum += flux[z];
    return sum;
  };
  const auto down = up_to(zones / 2);
  // Zones to about 41, 60, 75 and 90 degrees; 0.130 and 0.547 are the parts of cut zones.
  const std::array<double, 4> sums = {up_to(4) + 0.130 * flux[4], up_to(6), up_to(7) + 0.547 * flux[7], down};
  const auto& factors = floor_factors_of(room).factor;
  DirectFlux direct;
  for (std::size_t i = 0; i < sums.size(); ++i) direct.floor += factors[i] * sums[i];
  direct.wall = down - direct.floor;
  direct.ceiling = up_to(zones) - down;
  return direct;
}

std::size_t cells(double side, double spacing) {
  return static_cast<std::size_t>(std::max(1.0, std::round(side / spacing)));
}

// Sum of L² omega / p² over the luminaires of a room.
double glare_of(const Photometry& photometry, double spacing, const UgrRoom& room, bool endwise) {
  const auto columns = cells(room.across, spacing), rows = cells(room.along, spacing);
  // Whether the luminaire's local X points at the observer.
  const bool is_ies = photometry.format.rfind("IES", 0) == 0;
  const bool along_x = is_ies == endwise;
  double sum = 0.0;
  for (std::size_t i = 0; i < columns; ++i)
    for (std::size_t j = 0; j < rows; ++j) {
      const auto aside =
          room.across * ((static_cast<double>(i) + 0.5) / static_cast<double>(columns) - 0.5) * height;
      const auto forward = room.along * (static_cast<double>(j) + 0.5) / static_cast<double>(rows) * height;
      const auto index = position_index(forward, aside, height);
      if (!index) continue;
      const Vec3d towards_eye = along_x ? Vec3d(forward, -aside, -height) : Vec3d(aside, forward, -height);
      const auto squared_distance = glm::dot(towards_eye, towards_eye);
      const auto area = projected_area(photometry.opening, towards_eye);
      if (!(area > 0.0)) continue;
      const auto intensity = photometry.intensity.at(towards_eye);
      sum += intensity * intensity / (area * squared_distance * *index * *index);
    }
  return sum;
}

// cd/m²
double background_of(const std::array<double, zones>& flux, double spacing, const UgrRoom& room,
                     const RoomReflectance& reflectance) {
  const auto luminaires = static_cast<double>(cells(room.across, spacing) * cells(room.along, spacing));
  const auto wall_area = 2.0 * (room.across + room.along) * height * height;
  const auto direct = direct_flux(flux, room);
  const auto transfer = wall_transfer(room.across, room.along, reflectance);
  const auto illuminance = luminaires / wall_area *
                           (direct.floor * transfer.from_floor + direct.wall * transfer.from_wall +
                            direct.ceiling * transfer.from_ceiling);
  return illuminance / exact_pi;
}

void check(const Photometry& photometry, double spacing) {
  if (!(spacing >= 0.01 && spacing <= 12.0))
    throw InputError("the spacing of a UGR table must be from 0.01 to 12 times the height above the eye");
  if (photometry.opening.shape == OpeningShape::point)
    throw InputError(photometry.file,
                     "it has no luminous opening, so that its luminance is not known; UGR needs a file with "
                     "the sizes of the opening");
  if (!(photometry.intensity.linear_flux() > 0.0))
    throw InputError(photometry.file, "it emits no light, so that there is no UGR");
}

}  // namespace

bool is_symmetric(const IntensityDistribution& intensity) {
  constexpr int steps = 18;  // of 5 degrees
  const auto tolerance = 0.05 * intensity.maximum();
  for (int g = 1; g <= 2 * steps; ++g)
    for (int c = 0; c <= steps; ++c) {
      const auto gamma = sin_cos(exact_pi * g / (2 * steps)), around = sin_cos(0.5 * exact_pi * c / steps);
      const Vec3d d(gamma.sine * around.cosine, gamma.sine * around.sine, -gamma.cosine);
      const auto candela = intensity.at(d);
      for (const auto& mirror : {Vec3d(-1, 1, 1), Vec3d(1, -1, 1), Vec3d(-1, -1, 1)})
        if (std::abs(intensity.at(mirror * d) - candela) > tolerance) return false;
    }
  return true;
}

double UgrTerms::ugr() const {
  if (!(glare > 0.0) || !(background > 0.0)) return -std::numeric_limits<double>::infinity();
  return 8.0 * std::log10(0.25 * glare / background);
}

UgrTerms ugr_terms(const Photometry& photometry, double spacing, std::size_t room, std::size_t reflectances,
                   bool endwise) {
  check(photometry, spacing);
  return {glare_of(photometry, spacing, ugr_rooms.at(room), endwise),
          background_of(zonal_fluxes(photometry.intensity), spacing, ugr_rooms.at(room),
                        ugr_reflectances.at(reflectances))};
}

UgrTable ugr_table(const Photometry& photometry, double spacing) {
  check(photometry, spacing);
  UgrTable table{.spacing = spacing};
  const auto flux = zonal_fluxes(photometry.intensity);
  for (std::size_t r = 0; r < ugr_rooms.size(); ++r) {
    const auto& room = ugr_rooms[r];
    const auto crosswise = glare_of(photometry, spacing, room, false);
    const auto endwise = glare_of(photometry, spacing, room, true);
    for (std::size_t s = 0; s < ugr_reflectances.size(); ++s) {
      const auto background = background_of(flux, spacing, room, ugr_reflectances[s]);
      table.crosswise[r][s] = UgrTerms{crosswise, background}.ugr();
      table.endwise[r][s] = UgrTerms{endwise, background}.ugr();
    }
  }
  return table;
}

}  // namespace luxel
