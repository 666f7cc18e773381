// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace luxel {

/// View factors (form factors, configuration factors) between elements: F_ij is the share of the diffuse
/// power that leaves element i and arrives at element j straight, with what stands between respected. Sparse:
/// rows hold what is above 0.
struct ViewFactors {
  /// What leaves and arrives at no element: the environment; backs of surfaces that are no element; factors
  /// that were too small to keep.
  enum Sink : std::size_t { environment, backs, dropped };
  static constexpr std::size_t sinks = 3;
  static constexpr std::array<const char*, sinks> sink_name = {"environment", "backs", "dropped"};

  struct SinkColumn {
    std::vector<double> factor;         ///< [element], [0, 1]
    std::vector<float> standard_error;  ///< [element]
  };

  std::vector<std::string> name;  ///< [element]
  std::vector<double> area;       ///< [element], m²
  /// [element]: rays from it, counted as if all its patches were of one area; 0 where the row was not asked
  /// for, or needed none.
  std::vector<double> rays;

  /// Compressed rows: those of i are [row_begin[i], row_begin[i + 1]), columns rising.
  std::vector<std::uint64_t> row_begin;  ///< [element + 1]
  std::vector<std::uint32_t> column;
  std::vector<double> factor;         ///< (0, 1]
  std::vector<float> standard_error;  ///< absolute, 0 or more
  std::array<SinkColumn, sinks> sink;

  /// Whether the row was asked for.
  std::vector<std::uint8_t> is_known;  ///< [element]

  std::size_t size() const { return area.size(); }
  std::uint64_t count() const { return column.size(); }  ///< listed factors

  /// No factors yet, no rows known.
  static ViewFactors between(std::vector<std::string> names, std::vector<double> areas);
};

}  // namespace luxel
