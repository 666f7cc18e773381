// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/compact.h"

#include <cstddef>

#include <zlib.h>

#include "luxel/core/error.h"

namespace luxel {

std::string deflated(std::string_view bytes) {
  auto room = compressBound(bytes.size());
  std::string out(room, '\0');
  const auto status =
      compress2(reinterpret_cast<Bytef*>(out.data()), &room, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), Z_BEST_COMPRESSION);
  if (status != Z_OK) throw DeviceError("there is not enough memory to compress what is to be written");
  out.resize(room);
  return out;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<unsigned>(static_cast<unsigned char>(bytes[i + k])) : 0u;
    };
    const auto three = byte(0) << 16u | byte(1) << 8u | byte(2);
    text += digits[three >> 18u];
    text += digits[three >> 12u & 63u];
    text += i + 1 < bytes.size() ? digits[three >> 6u & 63u] : '=';
    text += i + 2 < bytes.size() ? digits[three & 63u] : '=';
  }
  return text;
}

}  // namespace luxel
