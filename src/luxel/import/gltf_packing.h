// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

enum class GltfCompression { plain, quantised, meshopt };

// How the arrays of a glTF file are stored.
struct GltfPacking {
  GltfCompression compression = GltfCompression::plain;
  // Only what glTF has without KHR_mesh_quantization: texture coordinates and colours.
  bool core_only = false;
  // Largest step of quantised positions, units of the file; meshes that need a larger one keep floats. The
  // default in metres moves a vertex by at most half a millimetre along each axis.
  double max_step = 0x1p-10;
  // Number of steps of the largest mesh: those of 16 bits, less one, since the grid's origin is rounded down;
  // with meshopt those of 15 bits, since a random bit cannot be compressed.
  double max_steps() const { return compression == GltfCompression::meshopt ? 32766.0 : 65534.0; }
  bool colours_are_srgb = false;  // COLOR_0 holds sRGB codes, not linear values
};

}  // namespace luxel
