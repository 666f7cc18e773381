// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "luxel/solution/check_solution.h"
#include "luxel/solution/focus_file.h"
#include "luxel/solution/hdf5_reader.h"
#include "luxel/solution/lights_file.h"
#include "luxel/solution/panes_file.h"
#include "luxel/solution/places_file.h"
#include "luxel/solution/portals_file.h"
#include "luxel/solution/provenance_file.h"
#include "luxel/solution/sample_file.h"
#include "luxel/solution/solution_file.h"
#include "luxel/solution/solution_layout.h"
#include "luxel/solution/surface_file.h"

namespace luxel {
namespace {

void check_version(Hdf5Reader& file) {
  if (!file.has("Luxel")) file.refuse("not a Luxel solution (no Luxel group)");
  const auto version = file.number<std::uint32_t>("Luxel", "format_version");
  if (version > solution_format_version)
    file.refuse(fmt::format("written by format version {}; this program reads up to {}: use a newer Luxel",
                            version, solution_format_version));
  if (version == 0) file.refuse_as_damaged("it claims format version 0");
  if (version == 1) file.use_names(names_of_version_1);
}

void check_count(const Hdf5Reader& file, const std::string& name, std::size_t expected) {
  const auto count = file.array<std::int64_t>(name, 1)[0];
  if (count != static_cast<std::int64_t>(expected))
    file.refuse_as_damaged(fmt::format("'{}' is {}, but the arrays hold {}", name, count, expected));
}

std::vector<std::array<std::uint32_t, 3>> read_corners(const Hdf5Reader& file, std::size_t n) {
  const auto connectivity = file.array<std::int64_t>("VTKHDF/Connectivity", 3 * n);
  std::vector<std::array<std::uint32_t, 3>> corners(n);
  for (std::size_t i = 0; i < connectivity.size(); ++i) {
    const auto index = connectivity[i];
    // The vertex number itself is checked later; here it must survive narrowing.
    if (index < 0 || index > std::numeric_limits<std::uint32_t>::max())
      file.refuse_as_damaged(fmt::format("patch {} names vertex {}", i / 3, index));
    corners[i / 3][i % 3] = static_cast<std::uint32_t>(index);
  }
  return corners;
}

// Checks that offsets and types describe triangles only.
void check_cells(const Hdf5Reader& file, std::size_t n) {
  const auto types = file.array<std::uint8_t>("VTKHDF/Types", n);
  if (!std::all_of(types.begin(), types.end(), [](auto type) { return type == vtk_triangle; }))
    file.refuse_as_damaged("'VTKHDF/Types' names a cell that is not a triangle");
  const auto offsets = file.array<std::int64_t>("VTKHDF/Offsets", n + 1);
  for (std::size_t i = 0; i <= n; ++i)
    if (offsets[i] != static_cast<std::int64_t>(3 * i))
      file.refuse_as_damaged(fmt::format("'VTKHDF/Offsets' is {} at {}, expected {}", offsets[i], i, 3 * i));
}

void read_mesh(const Hdf5Reader& file, PatchSet& patches) {
  // The numbers first: arrays of wrong lengths may be of gigabytes.
  const auto n = file.rows("VTKHDF/Types");
  const auto points = file.rows("VTKHDF/Points");
  check_count(file, "VTKHDF/NumberOfPoints", points);
  check_count(file, "VTKHDF/NumberOfCells", n);
  check_count(file, "VTKHDF/NumberOfConnectivityIds", 3 * n);
  check_cells(file, n);
  patches.origin = read_origin(file, "Luxel/origin");
  if (file.has("Luxel/up")) {
    const auto up = file.array<float>("Luxel/up", 3);
    patches.up = {up[0], up[1], up[2]};
  }
  patches.vertices = read_places(file, "VTKHDF/Points", points, patches.origin);
  patches.corners = read_corners(file, n);
  patches.normal = file.vectors("Luxel/normals", n);
  patches.area = file.array<float>("VTKHDF/CellData/area", n);
  patches.material = file.array<MaterialId>("VTKHDF/CellData/material", n);
  patches.triangle = file.array<std::uint32_t>("VTKHDF/CellData/triangle", n);
}

std::vector<Contact> read_contacts(const Hdf5Reader& file) {
  if (!file.has("Luxel/contacts")) return {};
  const auto n = file.rows("Luxel/contacts/into");
  const auto edges = file.array<std::uint32_t>("Luxel/contacts/edge", n, 2);
  const auto into = file.vectors("Luxel/contacts/into", n);
  std::vector<Contact> contacts(n);
  for (std::size_t i = 0; i < n; ++i) contacts[i] = {{edges[2 * i], edges[2 * i + 1]}, into[i]};
  return contacts;
}

std::vector<BandMaterial> read_materials(const Hdf5Reader& file, std::size_t bands) {
  const auto n = file.rows("Luxel/materials/name");
  const auto names = file.strings("Luxel/materials/name", n);
  const auto two_sided = file.array<std::uint8_t>("Luxel/materials/two_sided", n);
  const auto reflectance = file.array<float>("Luxel/materials/reflectance", n, bands);
  const auto emittance = file.array<float>("Luxel/materials/emittance", n, bands);
  std::vector<float> diffuse_transmittance(n * bands, 0.0f);
  if (file.has("Luxel/materials/diffuse_transmittance"))
    diffuse_transmittance = file.array<float>("Luxel/materials/diffuse_transmittance", n, bands);
  std::vector<BandMaterial> materials;
  for (std::size_t i = 0; i < n; ++i) {
    const auto begin = static_cast<std::ptrdiff_t>(i * bands);
    const auto end = begin + static_cast<std::ptrdiff_t>(bands);
    materials.push_back({names[i], two_sided[i] != 0,
                         std::vector(reflectance.begin() + begin, reflectance.begin() + end),
                         std::vector(emittance.begin() + begin, emittance.begin() + end), 0});
    const std::vector through(diffuse_transmittance.begin() + begin, diffuse_transmittance.begin() + end);
    if (std::any_of(through.begin(), through.end(), [](float t) { return t != 0.0f; }))
      materials.back().diffuse_transmittance = through;
  }
  return materials;
}

StopReason read_stop_reason(const Hdf5Reader& file) {
  const auto found = file.word("Luxel", "stop_reason");
  if (const auto reason = stop_reason(found)) return *reason;
  file.refuse_as_damaged(fmt::format("the stop reason '{}' is not known", found));
}

// Wavebands exist for spectra only; colour, and files from before spectra, have none.
std::vector<Waveband> read_wavebands(const Hdf5Reader& file, std::size_t bands) {
  if (!file.has("Luxel/wavelengths")) return {};
  const auto wavelengths = file.array<double>("Luxel/wavelengths", bands);
  const auto widths = file.array<double>("Luxel/widths", bands);
  std::vector<Waveband> wavebands;
  for (std::size_t b = 0; b < bands; ++b) wavebands.push_back({wavelengths[b], widths[b]});
  return wavebands;
}

Solution read_light(const Hdf5Reader& file, const std::vector<std::string>& bands, std::size_t n) {
  Solution solution;
  solution.bands = bands;
  for (const auto& [name, values] : light_arrays(solution))
    *values = file.array<float>(name, n, light_columns(bands.size()));
  // Optional arrays: added later, or not given by every method. A missing half of a pair is reported by the
  // check.
  for (const auto& [name, values] : error_arrays(solution))
    if (file.has(name)) *values = file.array<float>(name, n, light_columns(bands.size()));
  const auto later = [&](const char* name, double& value) {
    if (file.has_attribute("Luxel", name)) value = file.number<double>("Luxel", name);
  };
  later("error_95th", solution.error_95th);
  later("seen_error", solution.seen_error);
  later("error_degrees_of_freedom", solution.error_degrees_of_freedom);
  later("predicted_bias", solution.predicted_bias);
  later("mesh_error", solution.mesh_error);
  solution.unshot_fraction = file.number<double>("Luxel", "unshot_fraction");
  solution.predicted_error = file.number<double>("Luxel", "predicted_error");
  solution.stop = read_stop_reason(file);
  solution.provenance = read_provenance(file, "Luxel/provenance");
  return solution;
}

// Reads the light group of each material's lamps.
void read_light_groups(const Hdf5Reader& file, PatchSet& patches) {
  if (!file.has("Luxel/light_groups")) return;
  patches.light_groups = file.strings("Luxel/light_groups", file.rows("Luxel/light_groups"));
  const auto of = file.array<std::uint32_t>("Luxel/materials/light_group", patches.materials.size());
  for (std::size_t m = 0; m < of.size(); ++m) patches.materials[m].light_group = of[m];
}

void read_sky(Hdf5Reader& file, PatchSet& patches) {
  if (file.has("Luxel/sky_axes")) {
    const auto axes = file.array<double>("Luxel/sky_axes", 6);
    const Vec3d zenith(axes[0], axes[1], axes[2]), north(axes[3], axes[4], axes[5]);
    const auto cut = file.array<std::uint32_t>("Luxel/sky_subdivision", 2);
    const auto is_unit = [](const Vec3d& v) { return std::fabs(glm::dot(v, v) - 1.0) < 1e-6; };
    if (!is_unit(zenith) || !is_unit(north) || !(std::fabs(glm::dot(zenith, north)) < 1e-6) || cut[0] > 16 ||
        cut[1] > 1)
      file.refuse_as_damaged("the axes of its sky are not at right angles, or its patches are too many");
    patches.sky_patches = SkyPatches(static_cast<int>(cut[0]), zenith, north,
                                     cut[1] == 1 ? LowerHalf::mirrored : LowerHalf::one);
  }
  if (file.has("Luxel/sky"))
    patches.sky = file.array<float>("Luxel/sky", patches.sky_patches.size() * patches.band_count());
}

Baked read_baked(Hdf5Reader& file) {
  check_version(file);
  Baked baked;
  auto& [patches, solution] = baked;
  patches.bands = file.strings("Luxel/bands", file.rows("Luxel/bands"));
  if (patches.bands.empty()) file.refuse_as_damaged("it names no band");
  patches.wavebands = read_wavebands(file, patches.band_count());
  read_mesh(file, patches);
  patches.materials = read_materials(file, patches.band_count());
  read_light_groups(file, patches);
  read_sky(file, patches);
  read_surface(file, patches);
  read_point_lights(file, patches);
  read_portals(file, patches);
  read_panes(file, patches);
  solution = read_light(file, patches.bands, patches.size());
  patches.scene_fingerprint = solution.provenance.scene_fingerprint;
  patches.contacts = read_contacts(file);
  read_focus(file, patches);
  if (const auto fault = fault_in(patches, solution); !fault.empty()) file.refuse_as_damaged(fault);
  return baked;
}

}  // namespace

Baked read_solution(const std::filesystem::path& path) {
  Hdf5Reader file(path);
  return read_baked(file);
}

StoredRun read_stored_run(const std::filesystem::path& path) {
  Hdf5Reader file(path);
  StoredRun run{read_baked(file), nullptr};
  if (file.has("Luxel/samples"))
    run.samples = std::make_shared<SampleState>(read_samples(file, run.baked.patches));
  return run;
}

}  // namespace luxel
