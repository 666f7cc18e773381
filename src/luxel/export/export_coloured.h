// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "luxel/core/vector.h"

namespace luxel {

// Triangles of one plain colour.
struct ColouredMesh {
  std::string name;
  Vec3 colour{0.5f};                                    // linear, [0, 1]
  std::vector<Vec3> positions;                          // m
  std::vector<std::array<std::uint32_t, 3>> triangles;  // into positions
};

// Writes a GLB of meshes in plain colours, each with a node and a material of its name below a root called
// `title`. Unlit: the colours are shaded by the direction of a triangle, so that shapes are visible, and both
// sides are drawn. up and origin (m) as in export_glb(). Meshes without triangles are left out. Replaces the
// file atomically; throws DeviceError.
void export_coloured(const std::filesystem::path& path, const std::string& title,
                     std::span<const ColouredMesh> meshes, const Vec3& up, const Vec3d& origin = Vec3d(0.0));

}  // namespace luxel
