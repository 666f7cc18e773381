// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace luxel {

/// View factors (form factors, configuration factors) between elements: F_ij is the fraction of the diffuse
/// power leaving element i that arrives at element j directly, with occlusion. Sparse: rows hold the factors
/// above 0.
struct ViewFactors {
  /// Power that arrives at no element: the environment; backs of surfaces that are not elements; factors that
  /// were too small to list.
  enum Sink : std::size_t { environment, backs, dropped };
  static constexpr std::size_t sinks = 3;
  static constexpr std::array<const char*, sinks> sink_name = {"environment", "backs", "dropped"};

  struct SinkColumn {
    std::vector<double> factor;         ///< [element], [0, 1]
    std::vector<float> standard_error;  ///< [element]
  };

  std::vector<std::string> name;  ///< [element]
  std::vector<double> area;       ///< [element], m²
  /// [element]: rays from it, counted as if all its patches were of one area; 0 if the row was not requested
  /// or needed none.
  std::vector<double> rays;

  /// Compressed rows: those of i are [row_begin[i], row_begin[i + 1]), columns ascending.
  std::vector<std::uint64_t> row_begin;  ///< [element + 1]
  std::vector<std::uint32_t> column;
  std::vector<double> factor;         ///< (0, 1]
  std::vector<float> standard_error;  ///< absolute, 0 or more
  std::array<SinkColumn, sinks> sink;

  /// Whether the row was requested.
  std::vector<std::uint8_t> is_known;  ///< [element]

  std::size_t size() const { return area.size(); }
  std::uint64_t count() const { return column.size(); }  ///< listed factors

  /// No factors yet, no rows known.
  static ViewFactors between(std::vector<std::string> names, std::vector<double> areas);
};

}  // namespace luxel
