// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "luxel/image/raster.h"

#include "fuzz/answered.h"

namespace luxel {
namespace {

// A picture that was read has a value per pixel; linear ones are finite.
void expect_sound_raster(const Raster& raster) {
  expect(raster.width > 0 && raster.height > 0);
  const auto pixels = raster.index(0, raster.height);
  expect(raster.codes.size() == (raster.linear.empty() ? pixels : 0));
  expect(raster.linear.empty() || raster.linear.size() == pixels);
  for (const auto& value : raster.linear)
    expect(std::isfinite(value.r) && std::isfinite(value.g) && std::isfinite(value.b));
}

}  // namespace
}  // namespace luxel

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const char* name : {"nowhere/picture.png", "nowhere/picture.tga"})
    luxel::answered(data, size, [name](std::string_view bytes) {
      luxel::expect_sound_raster(luxel::decode_raster(bytes, name));
    });
  return 0;
}
