// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "luxel/export/target_application.h"
#include "luxel/image/tone.h"
#include "luxel/patch/patch_set.h"
#include "luxel/solution/solution.h"
#include "luxel/surface/smooth_light.h"

namespace luxel {

struct Baked;

struct ExportOptions {
  ToneOptions tone;
  TargetApplication program = TargetApplication::any;    ///< of a GLB
  MeshCompression compression = MeshCompression::plain;  ///< of a GLB; the command's default is quantised
};

/// A lit mesh for any viewer: one primitive per material and side, POSITION, NORMAL and COLOR_0
/// (tone-mapped light, linear, 16-bit normalised RGBA), KHR_materials_unlit; and, where the program keeps
/// it, _IRRADIANCE in W/m² by linear sRGB, as floats. The asset's extras describe both, with units and the
/// place of pi. ExportProfile has the differences between programs. A back side is written, as separate
/// triangles, only if light fell on it. glTF is Y up: a scene whose up is Z is turned by its root node.
/// Valid by the Khronos validator. The same node moves a scene that is far from its file's zero, so its
/// accessors are as exact as near zero. With a compression the mesh hangs below the root node, see
/// MeshCompression. The same input gives the same bytes. Written whole or not at all; throws DeviceError.
/// Throws MismatchError where the light is not of these patches or not plain colour, InputError where up
/// has no length, the mesh is beyond the 4 GiB of a GLB, or the compression is not available. A front
/// without light is written black, so that nothing disappears. The asset's extras describe how the light
/// was made. Cost: linear; the file is made in memory.
void export_glb(const std::filesystem::path& path, const PatchSet& patches, const Solution& solution,
                const SmoothLight& light, const Vec3& up, const ExportOptions& options = {});

/// Writes the mesh of a scene baked in one call (solve/bake.h), Y up, its light smoothed by default options.
void export_glb(const std::filesystem::path& path, const Baked& baked, const ExportOptions& options = {});

/// Binary PLY with the same triangles: x y z, nx ny nz, red green blue (8-bit sRGB), and `irradiance_<band>`
/// as float. x y z are doubles where the patches have an origin.
void export_ply(const std::filesystem::path& path, const PatchSet& patches, const Solution& solution,
                const SmoothLight& light, const ExportOptions& options = {});

}  // namespace luxel
