// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/export/export_mesh.h"
#include "luxel/export/lit_mesh.h"
#include "luxel/image/image.h"

namespace luxel {
namespace {

static_assert(std::endian::native == std::endian::little, "the file says binary_little_endian");

template <typename T>
void put(std::string& bytes, T value) {
  const auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  bytes.append(raw.data(), raw.size());
}

std::string header(bool is_far, std::size_t vertices, std::size_t triangles) {
  auto text = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment light by Luxel, irradiance in W/m2\nelement vertex {}\n",
      vertices);
  for (const auto* name : {"x", "y", "z"})
    text += fmt::format("property {} {}\n", is_far ? "double" : "float", name);
  for (const auto* name : {"nx", "ny", "nz"}) text += fmt::format("property float {}\n", name);
  for (const auto* name : {"red", "green", "blue"}) text += fmt::format("property uchar {}\n", name);
  for (const auto* name : {"red", "green", "blue"})
    text += fmt::format("property float irradiance_{}\n", name);
  return text +
         fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", triangles);
}

std::uint8_t srgb_byte(float linear) {
  return static_cast<std::uint8_t>(std::lround(srgb_encode(std::clamp(linear, 0.0f, 1.0f)) * 255.0f));
}

void put_vertex(std::string& bytes, const LitVertex& v, const Vec3d& origin) {
  for (int i = 0; i < 3; ++i) {
    if (origin == Vec3d(0.0))
      put(bytes, v.position[i]);
    else
      put(bytes, origin[i] + static_cast<double>(v.position[i]));
  }
  for (int i = 0; i < 3; ++i) put(bytes, v.normal[i]);
  for (int i = 0; i < 3; ++i) put(bytes, srgb_byte(v.colour[i]));
  for (int i = 0; i < 3; ++i) put(bytes, v.irradiance[i]);
}

}  // namespace

void export_ply(const std::filesystem::path& path, const PatchSet& patches, const Solution& solution,
                const SmoothLight& light, const ExportOptions& options) {
  const LitMesh mesh(patches, solution, light, options.tone);
  std::size_t vertices = 0, triangles = 0;
  for (const auto& part : mesh.parts()) {
    vertices += part.smooth.size();
    triangles += part.triangles.size();
  }
  if (vertices > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    throw InputError(path.string(), fmt::format("the lit mesh has {} vertices, more than a PLY index counts: "
                                                "cut the scene into larger patches",
                                                vertices));

  auto bytes = header(patches.origin != Vec3d(0.0), vertices, triangles);
  for (const auto& part : mesh.parts())
    for (std::size_t i = 0; i < part.smooth.size(); ++i)
      put_vertex(bytes, mesh.vertex(part, i), patches.origin);
  std::uint32_t first = 0;  // of the part's vertices
  for (const auto& part : mesh.parts()) {
    for (const auto& triangle : part.triangles) {
      put(bytes, std::uint8_t{3});
      for (const auto i : triangle) put(bytes, static_cast<std::int32_t>(first + i));
    }
    first += static_cast<std::uint32_t>(part.smooth.size());
  }
  write_file(path, bytes);
}

}  // namespace luxel
