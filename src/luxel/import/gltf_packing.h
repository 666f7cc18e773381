// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

enum class GltfCompression { none, quantised, meshopt };

// How the arrays of a glTF file are stored.
struct GltfPacking {
  GltfCompression compression = GltfCompression::none;
  // Only what glTF has without KHR_mesh_quantization: texture coordinates and colours.
  bool core_only = false;
  // Largest step of quantised positions, units of the file; meshes that need a larger one keep floats. The
  // default in metres moves a vertex by at most half a millimetre along each axis, and spans 64 m.
  double max_step = 0x1p-10;
  bool colours_are_srgb = false;  // COLOR_0 holds sRGB codes, not linear values
};

}  // namespace luxel
