// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/glb_container.h"

#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "luxel/core/error.h"

namespace luxel {
namespace {

constexpr std::size_t alignment = 4;  // of the chunks

std::string little_endian(std::size_t number) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(number >> 8 * i & 0xff);
  return bytes;
}

}  // namespace

std::string glb_container(SortedJson root, std::string_view binary, const std::string& source) {
  if (binary.empty())
    root.erase("buffers");
  else
    root["buffers"][0]["byteLength"] = binary.size();
  auto text = json_text(root);
  text.resize((text.size() + alignment - 1) / alignment * alignment, ' ');
  const auto padding = (alignment - binary.size() % alignment) % alignment;
  constexpr std::size_t header = 12, chunk_header = 8;
  const auto size =
      header + chunk_header + text.size() + (binary.empty() ? 0 : chunk_header + binary.size() + padding);
  if (size > std::numeric_limits<std::uint32_t>::max())
    throw InputError(source, fmt::format("a GLB has at most 4 GiB, and this one would have {:.1f}; "
                                         "export fewer surfaces or a smaller lightmap",
                                         static_cast<double>(size) / (std::size_t{1} << 30)));
  std::string file = "glTF" + little_endian(2) + little_endian(size);
  file += little_endian(text.size()) + "JSON" + text;
  if (binary.empty()) return file;
  file += little_endian(binary.size() + padding) + std::string("BIN\0", 4);
  return file.append(binary).append(padding, '\0');
}

}  // namespace luxel
