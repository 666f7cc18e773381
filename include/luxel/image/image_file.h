// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "luxel/core/context.h"
#include "luxel/image/image.h"
#include "luxel/image/raster.h"

namespace luxel {

/// \file
/// Each writer makes the file whole or not at all (OutputFile) and throws DeviceError where it cannot, or
/// where there is no pixel to write. NaN is written as 0. The same pixels give the same bytes. The file is
/// made in memory first.

/// Writes an 8-bit sRGB PNG of a display-referred image: clamped to [0, 1], sRGB encoded, rounded, with an
/// sRGB chunk. notes: keywords of up to 79 Latin letters with their texts, as text chunks of the file.
using PictureNotes = std::vector<std::pair<std::string, std::string>>;
void write_png(const std::filesystem::path& path, const Image& display, const PictureNotes& notes = {});
/// Returns the same file in memory; empty after the monitor's stop.
std::string png_of(const Image& display, const PictureNotes& notes = {}, const Context& context = {});
/// Encodes the raster's codes with their alpha; linear values are clamped to [0, 1] first.
std::string png_of(const Raster& raster);
/// Writes scene-referred linear values unchanged: OpenEXR (half floats, ZIP; within ±65504) and Radiance RGBE
/// (0 to 1e38).
void write_exr(const std::filesystem::path& path, const Image& linear);
std::string exr_of(const Image& linear, const Context& context = {});  ///< as png_of()
void write_hdr(const std::filesystem::path& path, const Image& linear);

/// PNG, JPEG, WebP, BMP, Radiance HDR, OpenEXR (recognised by their first bytes) or TGA (by its extension) as
/// linear RGB; 8-bit files are taken as sRGB, deeper PNG files are reduced to 8 bits, grey becomes RGB, alpha
/// is dropped. In the files of linear values NaN becomes 0 and infinity 65504. Throws InputError naming the
/// file where it is missing, damaged, of another format, larger than 512 MiB or than 16384 pixels per side.
Image read_image(const std::filesystem::path& path);

}  // namespace luxel
