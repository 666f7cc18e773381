// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "luxel/image/image.h"

namespace luxel {

// Each writer makes the file whole or not at all (OutputFile) and throws DeviceError where it cannot.

// 8-bit sRGB PNG of a display-referred image: clamped to [0, 1], sRGB encoded, rounded, with an sRGB chunk.
void write_png(const std::filesystem::path& path, const Image& display);
// Scene-referred linear values as they are: OpenEXR (half floats, ZIP) and Radiance RGBE.
void write_exr(const std::filesystem::path& path, const Image& linear);
void write_hdr(const std::filesystem::path& path, const Image& linear);

// PNG, JPEG, TGA, BMP or HDR as linear RGB (8-bit files are taken as sRGB); alpha is dropped. Throws
// InputError naming the file where it is missing, damaged, or larger than 16384 pixels a side.
Image read_image(const std::filesystem::path& path);

// The mean of all pixels (double sums), linear.
Vec3 mean_color(const Image& image);

}  // namespace luxel
