// SPDX-License-Identifier: Apache-2.0
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/scene/band_colours.h"
#include "luxel/solution/check_solution.h"
#include "luxel/solution/focus_file.h"
#include "luxel/solution/hdf5_writer.h"
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

void add_count(Hdf5Writer& file, const std::string& name, std::size_t count) {
  file.add_array(name, flat(std::vector{static_cast<std::int64_t>(count)}));
}

// One partition, with one triangle cell per patch. VTK reads indices as its own 64-bit type.
void add_mesh(Hdf5Writer& file, const PatchSet& patches) {
  const auto n = patches.size();
  file.add_group("VTKHDF");
  file.add_attribute("VTKHDF", "Version", flat(std::vector<std::int64_t>{1, 0}));
  file.add_word("VTKHDF", "Type", "UnstructuredGrid");
  add_count(file, "VTKHDF/NumberOfPoints", patches.vertices.size());
  add_count(file, "VTKHDF/NumberOfCells", n);
  add_count(file, "VTKHDF/NumberOfConnectivityIds", 3 * n);
  add_places(file, "VTKHDF/Points", patches.vertices, patches.origin);
  std::vector<std::int64_t> connectivity;
  connectivity.reserve(3 * n);
  for (const auto& corners : patches.corners)
    connectivity.insert(connectivity.end(), corners.begin(), corners.end());
  file.add_array("VTKHDF/Connectivity", flat(connectivity));
  std::vector<std::int64_t> offsets(n + 1);
  for (std::size_t i = 0; i <= n; ++i) offsets[i] = static_cast<std::int64_t>(3 * i);
  file.add_array("VTKHDF/Offsets", flat(offsets));
  file.add_array("VTKHDF/Types", flat(std::vector(n, vtk_triangle)));
}

void add_cells(Hdf5Writer& file, const PatchSet& patches, const Solution& solution) {
  file.add_group("VTKHDF/CellData");
  const auto columns = light_columns(patches.band_count());
  for (const auto& [name, values] : light_arrays(solution))
    file.add_array(name, table(std::span(*values), patches.size(), columns), "W/m^2");
  for (const auto& [name, values] : error_arrays(solution))
    if (!values->empty()) file.add_array(name, table(std::span(*values), patches.size(), columns), "W/m^2");
  file.add_array("VTKHDF/CellData/area", flat(patches.area), "m^2");
  file.add_array("VTKHDF/CellData/triangle", flat(patches.triangle));
  file.add_array("VTKHDF/CellData/material", flat(patches.material));
}

void add_sky(Hdf5Writer& file, const PatchSet& patches) {
  if (patches.sky.empty()) return;
  file.add_array("Luxel/sky", flat(patches.sky), "W/(m^2 sr)");
  const auto& sky = patches.sky_patches;
  if (sky.is_one()) return;
  const auto &up = sky.zenith(), &north = sky.north();
  file.add_array("Luxel/sky_axes", flat(std::vector<double>{up.x, up.y, up.z, north.x, north.y, north.z}),
                 "1");
  file.add_array("Luxel/sky_subdivision",
                 flat(std::vector<std::uint32_t>{static_cast<std::uint32_t>(sky.subdivision()),
                                                 sky.lower_half() == LowerHalf::mirrored ? 1u : 0u}));
}

void add_materials(Hdf5Writer& file, const PatchSet& patches) {
  std::vector<std::string> names;
  std::vector<std::uint8_t> two_sided;
  std::vector<float> reflectance, emittance;
  std::vector<std::uint32_t> light_group;
  for (const auto& material : patches.materials) {
    names.push_back(material.name);
    two_sided.push_back(material.two_sided ? 1 : 0);
    reflectance.insert(reflectance.end(), material.reflectance.begin(), material.reflectance.end());
    emittance.insert(emittance.end(), material.emittance.begin(), material.emittance.end());
    light_group.push_back(material.light_group);
  }
  const auto by_band = [&](const std::vector<float>& values) {
    return table(std::span(values), patches.materials.size(), patches.band_count());
  };
  file.add_group("Luxel/materials");
  file.add_strings("Luxel/materials/name", names);
  file.add_array("Luxel/materials/two_sided", flat(two_sided));
  file.add_array("Luxel/materials/reflectance", by_band(reflectance), "1");
  file.add_array("Luxel/materials/emittance", by_band(emittance), "W/m^2");
  if (patches.has_diffusers()) {
    std::vector<float> transmittance;
    for (const auto& m : patches.materials)
      for (std::size_t b = 0; b < patches.band_count(); ++b)
        transmittance.push_back(m.is_diffuser() ? m.diffuse_transmittance[b] : 0.0f);
    file.add_array("Luxel/materials/diffuse_transmittance", by_band(transmittance), "1");
  }
  if (patches.light_groups.empty()) return;
  file.add_strings("Luxel/light_groups", patches.light_groups);
  file.add_array("Luxel/materials/light_group", flat(light_group));
}

void add_contacts(Hdf5Writer& file, const PatchSet& patches) {
  if (patches.contacts.empty()) return;
  std::vector<std::uint32_t> edges;
  std::vector<Vec3> into;
  for (const auto& contact : patches.contacts) {
    edges.insert(edges.end(), contact.edge.begin(), contact.edge.end());
    into.push_back(contact.into);
  }
  file.add_group("Luxel/contacts");
  file.add_array("Luxel/contacts/edge", table(std::span<const std::uint32_t>(edges), into.size(), 2));
  file.add_array("Luxel/contacts/into", vectors(into), "1");
}

// Writes the appearance of the bands, for other readers.
void add_wavebands(Hdf5Writer& file, const PatchSet& patches) {
  if (patches.wavebands.empty()) return;
  std::vector<double> wavelengths, widths, rgb;
  const auto colours = patches.colours();
  for (std::size_t b = 0; b < patches.wavebands.size(); ++b) {
    wavelengths.push_back(patches.wavebands[b].wavelength);
    widths.push_back(patches.wavebands[b].width);
    for (int i = 0; i < 3; ++i) rgb.push_back(colours.of(b)[i]);
  }
  file.add_array("Luxel/wavelengths", flat(wavelengths), "nm");
  file.add_array("Luxel/widths", flat(widths), "nm");
  file.add_array("Luxel/linear_srgb", table(std::span<const double>(rgb), wavelengths.size(), 3), "1");
}

void add_luxel(Hdf5Writer& file, const PatchSet& patches, const Solution& solution) {
  file.add_group("Luxel");
  file.add_number("Luxel", "format_version", solution_format_version);
  file.add_word("Luxel", "stop_reason", std::string(name(solution.stop)));
  file.add_number("Luxel", "unshot_fraction", solution.unshot_fraction);
  file.add_number("Luxel", "predicted_error", solution.predicted_error);
  if (solution.error_95th > 0.0) file.add_number("Luxel", "error_95th", solution.error_95th);
  if (solution.seen_error > 0.0) file.add_number("Luxel", "seen_error", solution.seen_error);
  if (solution.error_degrees_of_freedom > 0.0)
    file.add_number("Luxel", "error_degrees_of_freedom", solution.error_degrees_of_freedom);
  if (solution.predicted_bias > 0.0) file.add_number("Luxel", "predicted_bias", solution.predicted_bias);
  if (solution.mesh_error > 0.0) file.add_number("Luxel", "mesh_error", solution.mesh_error);
  file.add_strings("Luxel/bands", solution.bands);
  add_wavebands(file, patches);
  // Stored, not recomputed from the corners on reading: a normal is exactly that of the input triangle.
  file.add_array("Luxel/normals", vectors(patches.normal), "1");
  add_materials(file, patches);
  add_origin(file, "Luxel/origin", patches.origin);
  if (patches.up != Vec3(0.0f))
    file.add_array("Luxel/up", flat_array(std::span<const float>(&patches.up.x, 3)), "1");
  add_sky(file, patches);
  add_contacts(file, patches);
  add_surface(file, patches);
  add_point_lights(file, patches);
  add_portals(file, patches);
  add_panes(file, patches);
  add_focus(file, patches);
  add_provenance(file, "Luxel/provenance", solution.provenance);
}

}  // namespace

void write_solution(const std::filesystem::path& path, const PatchSet& patches, const Solution& solution,
                    const SampleState* samples) {
  if (const auto fault = fault_in(patches, solution); !fault.empty())
    throw MismatchError(cannot_write(path.string(), fault).what(), path.string());
  Hdf5Writer file;
  std::string_view bytes;
  try {
    add_mesh(file, patches);
    add_cells(file, patches, solution);
    add_luxel(file, patches, solution);
    if (samples) add_samples(file, *samples);
    bytes = file.finish();
  } catch (const DeviceError& error) {
    throw cannot_write(path.string(), error.what());
  }
  write_file(path, bytes);
}

}  // namespace luxel
