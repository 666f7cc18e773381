// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "luxel/solution/solution.h"

namespace luxel {

// What writing and reading a solution file must agree on; docs/solution-file.md is the whole layout.

inline constexpr std::uint32_t solution_format_version = 1;
inline constexpr std::uint8_t vtk_triangle = 5;  // VTK's number of the cell type

// VTK 9.1 reads a table of one column only where it is a flat array.
inline std::size_t light_columns(std::size_t band_count) { return band_count == 1 ? 0 : band_count; }

// The light's arrays with their names in the file, of a Solution that is const or not.
template <typename SolutionType>
auto light_arrays(SolutionType& solution) {
  return std::array{std::pair("VTKHDF/CellData/radiosity_front", &solution.radiosity_front),
                    std::pair("VTKHDF/CellData/radiosity_back", &solution.radiosity_back),
                    std::pair("VTKHDF/CellData/irradiance_front", &solution.irradiance_front),
                    std::pair("VTKHDF/CellData/irradiance_back", &solution.irradiance_back)};
}

// Likewise, of the arrays that only some methods give: in the file where they are not empty.
template <typename SolutionType>
auto error_arrays(SolutionType& solution) {
  return std::array{std::pair("VTKHDF/CellData/standard_error_front", &solution.standard_error_front),
                    std::pair("VTKHDF/CellData/standard_error_back", &solution.standard_error_back),
                    std::pair("VTKHDF/CellData/sharing_bias_front", &solution.sharing_bias_front),
                    std::pair("VTKHDF/CellData/sharing_bias_back", &solution.sharing_bias_back)};
}

inline const std::array<std::pair<StopReason, std::string>, 7>& stop_reason_words() {
  static const std::array<std::pair<StopReason, std::string>, 7> words = {
      {{StopReason::converged, "converged"},
       {StopReason::error_reached, "error_reached"},
       {StopReason::ray_limit, "ray_limit"},
       {StopReason::time_limit, "time_limit"},
       {StopReason::stopped_by_user, "stopped_by_user"},
       {StopReason::nothing_to_do, "nothing_to_do"},
       {StopReason::step_limit, "step_limit"}}};
  return words;
}

}  // namespace luxel
