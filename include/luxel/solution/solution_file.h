// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"

namespace luxel {

struct SampleState;

/// Whether a file is a solution, by its ending: .vtkhdf, in small letters or large.
bool is_solution(const std::filesystem::path& path);

/// What a .vtkhdf file holds: the light and the patches it lies on.
struct Baked {
  PatchSet patches;
  Solution solution;
};

/// HDF5 in the VTKHDF UnstructuredGrid layout, version 1.0, one triangle cell per patch, so that ParaView and
/// h5py read it. Cell arrays: radiosity.front/back, irradiance.front/back and, where the method gives them,
/// standard_error.front/back (W/m², [cell][band]), area, triangle, material. What only Luxel needs (bands,
/// materials, provenance, format version) stands in a group "Luxel" beside "VTKHDF". docs/solution-file.md is
/// the whole layout. The same input gives the same bytes. Made in memory, so it costs the file's size there.
/// Whole or not at all; throws DeviceError where the disk fails, MismatchError where patches and solution do
/// not fit together or a number is not finite. samples: what the run that made it needs to go on, and what
/// relighting needs; kept in the file as well.
void write_solution(const std::filesystem::path& path, const PatchSet& patches, const Solution& solution,
                    const SampleState* samples = nullptr);

/// What write_solution wrote, to the bit. Everything is checked: arrays are of one length, indices in range,
/// numbers finite, normals unit, areas above zero. Throws InputError where there is no such file, FormatError
/// where it is damaged, is not a solution, or is of a newer format version.
Baked read_solution(const std::filesystem::path& path);

/// The same, and the samples that its run knew: none where they were not kept.
struct StoredRun {
  Baked baked;
  std::shared_ptr<const SampleState> samples;
};
StoredRun read_stored_run(const std::filesystem::path& path);

}  // namespace luxel
