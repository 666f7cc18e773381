// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"

namespace luxel {

struct SampleState;

/// Returns whether a file's extension is that of a solution: .vtkhdf, in small or capital letters.
bool is_solution(const std::filesystem::path& path);

/// Contents of a .vtkhdf file: the light, and the patches that it lies on.
struct Baked {
  PatchSet patches;
  Solution solution;
};

/// Writes HDF5 in the VTKHDF UnstructuredGrid layout, version 1.0, one triangle cell per patch, so that
/// ParaView and h5py read it. Cell arrays: radiosity.front/back, irradiance.front/back and, where the method
/// gives them, standard_error.front/back (W/m², [cell][band]), area, triangle, material. Data that only Luxel
/// needs (bands, materials, provenance, format version) are in a group "Luxel" beside "VTKHDF".
/// docs/solution-file.md has the whole layout. The same input gives the same bytes. The file is built in
/// memory, which takes its size, and written completely or not at all; throws DeviceError where the disk
/// fails, MismatchError where patches and solution do not fit together or a number is not finite. samples:
/// data for resuming the run and for relighting; stored as well.
void write_solution(const std::filesystem::path& path, const PatchSet& patches, const Solution& solution,
                    const SampleState* samples = nullptr);

/// Reads the exact data that write_solution() wrote. Everything is checked: arrays are of one length, indices
/// in range, numbers finite, normals unit, areas above zero. Throws InputError where there is no such file,
/// FormatError where it is damaged, is not a solution, or is of a newer format version.
Baked read_solution(const std::filesystem::path& path);

/// A solution with the samples of its run; null where the file has no samples.
struct StoredRun {
  Baked baked;
  std::shared_ptr<const SampleState> samples;
};
StoredRun read_stored_run(const std::filesystem::path& path);

}  // namespace luxel
