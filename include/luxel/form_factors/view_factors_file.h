// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "luxel/core/vector.h"
#include "luxel/form_factors/view_factors.h"
#include "luxel/solution/solution.h"

namespace luxel {

inline constexpr std::uint32_t view_factors_format_version = 1;

/// Description of the factors in a file.
struct ViewFactorsNote {
  std::string between;    ///< "groups", "objects", "materials", "patches"
  std::string sides;      ///< "front", "both"
  bool enforced = false;  ///< the laws were enforced
  Provenance provenance;  ///< method: "counted" or "exact"
  /// Triangles of elements that are patches; else empty.
  std::vector<std::uint32_t> triangle;  ///< [element]: of the scene file
  std::vector<Vec3> centre;             ///< [element], m, counted from the origin of the patches
  Vec3d origin = Vec3d(0.0);
};

/// Writes an HDF5 file, completely or not at all; docs/view-factors.md describes the layout. The same input
/// gives the same bytes. The file is built in memory, which takes its size: about 16 bytes per listed factor,
/// less and slower where it is compressed. Throws DeviceError where the disk fails.
void write_view_factors_hdf5(const std::filesystem::path& path, const ViewFactors& factors,
                             const ViewFactorsNote& note, bool is_compressed = false);

/// The exact content of such a file. All that can be checked is checked: lengths, indices, finite numbers.
/// Throws InputError where there is no such file, FormatError where it is damaged, something else or newer.
struct StoredViewFactors {
  ViewFactors factors;
  ViewFactorsNote note;
};
StoredViewFactors read_view_factors_hdf5(const std::filesystem::path& path);

/// Writes one line per factor: from,to,factor,standard_error (RFC 4180: names that need it in quotes). Sinks
/// stand as "(environment)", "(backs)", "(dropped)" where they are not 0. Completely or not at all.
void write_view_factors_csv(const std::filesystem::path& path, const ViewFactors& factors);

/// Writes Matrix Market, "coordinate real general": line i, column j, F_ij, counted from 1, with names and
/// areas as comments. Completely or not at all.
void write_view_factors_matrix_market(const std::filesystem::path& path, const ViewFactors& factors,
                                      const ViewFactorsNote& note);

}  // namespace luxel
