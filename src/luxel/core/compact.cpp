// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/compact.h"

#include <array>
#include <cstddef>
#include <cstdint>

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

std::string base85(std::string_view bytes) {
  constexpr std::string_view digits =
      "!#%()*+,./0123456789:;=?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[]^_abcdefghijklmnopqrstuvwxyz{|}~";
  static_assert(digits.size() == 85);
  std::string text;
  text.reserve((bytes.size() + 3) / 4 * 5);
  for (std::size_t i = 0; i < bytes.size(); i += 4) {
    std::uint32_t four = 0;
    for (std::size_t k = i; k < i + 4; ++k)
      four = four << 8u | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u);
    std::array<char, 5> group{};
    for (std::size_t k = group.size(); k-- > 0; four /= 85u) group[k] = digits[four % 85u];
    text.append(group.data(), group.size());
  }
  return text;
}

}  // namespace luxel
