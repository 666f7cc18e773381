// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "luxel/lighting/room_transfer.h"
#include "luxel/photometry/photometry.h"

namespace luxel {

// A room of the standard table, in units of H, the height of the luminaires above the eye.
struct UgrRoom {
  double across = 4.0;  // at right angles to the line of sight
  double along = 8.0;   // along the line of sight
};

inline constexpr std::array<UgrRoom, 19> ugr_rooms = {{{2, 2},
                                                       {2, 3},
                                                       {2, 4},
                                                       {2, 6},
                                                       {2, 8},
                                                       {2, 12},
                                                       {4, 2},
                                                       {4, 3},
                                                       {4, 4},
                                                       {4, 6},
                                                       {4, 8},
                                                       {4, 12},
                                                       {8, 4},
                                                       {8, 6},
                                                       {8, 8},
                                                       {8, 12},
                                                       {12, 4},
                                                       {12, 6},
                                                       {12, 8}}};
inline constexpr std::array<RoomReflectance, 5> ugr_reflectances = {
    {{0.7, 0.5, 0.2}, {0.7, 0.3, 0.2}, {0.5, 0.5, 0.2}, {0.5, 0.3, 0.2}, {0.3, 0.3, 0.2}}};

// UGR by room and reflectances; minus infinity where no luminaire shines at the observer.
using UgrValues = std::array<std::array<double, ugr_reflectances.size()>, ugr_rooms.size()>;

struct UgrTable {
  double spacing = 0.25;  // of the luminaires, in units of H
  UgrValues crosswise{};  // seen at right angles to the luminaire's length
  UgrValues endwise{};    // seen along it
};

// Parts of a value of the table.
struct UgrTerms {
  double glare = 0.0;       // sum of L² omega / p², cd²/m⁴ sr
  double background = 0.0;  // luminance of the background, cd/m²
  double ugr() const;
};

// The standard table of a luminaire by the tabular method of CIE 190:2010 and CIE 117:1995: luminaires 2 m
// above the eye on a grid of this spacing in units of H, the observer at the middle of a wall. Grids fill the
// room: cells of room / spacing rounded, at least one.
//
// Crosswise is seen from C0 in EULUMDAT and from the horizontal angle 90 in IES files, whose lengths lie
// along different axes. Throws InputError where the luminaire has no luminous opening or no light goes down.
// Costs some 10 ms.
UgrTable ugr_table(const Photometry& photometry, double spacing = 0.25);

// The same in parts, for one room.
UgrTerms ugr_terms(const Photometry& photometry, double spacing, std::size_t room, std::size_t reflectances,
                   bool endwise);

// Returns whether the distribution is alike about both vertical planes, to 5 % of its largest value. UGR
// tables are made for such luminaires; others are seen from C0 and C90 (IES: 90 and 0).
bool is_symmetric(const IntensityDistribution& intensity);

// Names of a set of reflectances: "70/50/20", ceiling, walls and floor in per cent.
std::string name_of(const RoomReflectance& reflectance);

// For a person, as catalogues have it; and with a line of names, then a line per room.
std::string text_of(const UgrTable& table);
std::string csv_of(const UgrTable& table);

}  // namespace luxel
