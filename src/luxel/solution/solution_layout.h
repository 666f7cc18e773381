// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "luxel/solution/solution.h"

namespace luxel {

// Definitions common to writing and reading a solution file; docs/solution-file.md has the whole layout.

inline constexpr std::uint32_t solution_format_version = 2;

// Names of version 2, and the corresponding names of version 1.
inline constexpr std::array<std::pair<std::string_view, std::string_view>, 8> names_of_version_1 = {
    {{"smoothing_bias_front", "sharing_bias_front"},
     {"smoothing_bias_back", "sharing_bias_back"},
     {"reflectance_ratio", "reflectance_share"},
     {"emittance_ratio", "emittance_share"},
     {"receiver", "slot"},
     {"rays_per_replicate", "rays_a_replicate"},
     {"unshot_fraction", "unshot_share"},
     {"error_degrees_of_freedom", "error_freedom"}}};

inline constexpr std::uint8_t vtk_triangle = 5;  // VTK's number of the cell type

// VTK 9.1 reads a table of one column only where it is a flat array.
inline std::size_t light_columns(std::size_t band_count) { return band_count == 1 ? 0 : band_count; }

// The light's arrays with their names in the file, of a Solution that is const or not.
template <typename SolutionType>
auto light_arrays(SolutionType& solution) {
  return std::array{std::pair("VTKHDF/CellData/radiosity_front", &solution.radiosity.front),
                    std::pair("VTKHDF/CellData/radiosity_back", &solution.radiosity.back),
                    std::pair("VTKHDF/CellData/irradiance_front", &solution.irradiance.front),
                    std::pair("VTKHDF/CellData/irradiance_back", &solution.irradiance.back)};
}

// Arrays that only some methods give, in the same form: in the file where they are not empty.
template <typename SolutionType>
auto error_arrays(SolutionType& solution) {
  return std::array{std::pair("VTKHDF/CellData/standard_error_front", &solution.standard_error.front),
                    std::pair("VTKHDF/CellData/standard_error_back", &solution.standard_error.back),
                    std::pair("VTKHDF/CellData/smoothing_bias_front", &solution.smoothing_bias.front),
                    std::pair("VTKHDF/CellData/smoothing_bias_back", &solution.smoothing_bias.back)};
}

}  // namespace luxel
