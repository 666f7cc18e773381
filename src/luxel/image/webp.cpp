// SPDX-License-Identifier: Apache-2.0
#include "luxel/image/codec.h"

#ifdef LUXEL_HAS_WEBP
#include <webp/decode.h>
#endif

namespace luxel {

#ifndef LUXEL_HAS_WEBP

Raster decode_webp(std::string_view) {
  throw CodecError(
      "the picture is WebP, and this luxel was built without it; install libwebp-dev and build again, or "
      "convert the "
      "picture to PNG");
}

#else

Raster decode_webp(std::string_view bytes) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK)
    throw CodecError("the picture is damaged: it is no WebP that can be decoded");
  if (features.has_animation) throw CodecError("the picture moves; expected a WebP of one frame");
  check_size(features.width, features.height, bytes.size());
  Raster raster{features.width, features.height, {}, {}};
  raster.codes.resize(static_cast<std::size_t>(features.width) * static_cast<std::size_t>(features.height));
  auto* codes = reinterpret_cast<std::uint8_t*>(raster.codes.data());
  if (!WebPDecodeRGBAInto(data, bytes.size(), codes, raster.codes.size() * sizeof(Raster::Code),
                          4 * features.width))
    throw CodecError("the picture is damaged: its WebP data ends early or cannot be decoded");
  return raster;
}

#endif

}  // namespace luxel
