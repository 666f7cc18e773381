// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/gltf_file.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/import/gltf_decompress.h"
#include "luxel/import/uri.h"

namespace luxel {
namespace {

constexpr std::string_view magic = "glTF";
constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;  // "JSON", "BIN"

std::uint32_t little_endian(std::string_view bytes) {
  std::uint32_t number = 0;
  for (std::size_t i = 4; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[i]);
  return number;
}

}  // namespace

GltfFile::GltfFile(const std::filesystem::path& path, const std::vector<std::string_view>& extensions,
                   bool allow_outside)
    : GltfFile(read_file(path), path, extensions, allow_outside) {}

GltfFile::GltfFile(std::string bytes, const std::filesystem::path& path,
                   const std::vector<std::string_view>& extensions, bool allow_outside)
    : source_(path.string()),
      folder_(path.parent_path()),
      permitted_(path, allow_outside),
      bytes_(std::move(bytes)),
      text_(read_container()),
      root_(JsonValue::parse(text_, source_)) {
  check_version(extensions);
  if (auto decoded = decompress_gltf(*this)) {
    for (auto& [number, buffer] : decoded->buffers) buffers_[number] = std::move(buffer);
    decoded_text_ = std::move(decoded->text);
    text_ = decoded_text_;
    root_ = JsonValue::parse(text_, source_);
  }
}

// A GLB has a header of 12 bytes (magic, version, length), then chunks of length, kind and bytes: JSON first,
// then one of binary data; further ones are for extensions. Returns the JSON, which is the whole file in a
// .gltf.
std::string_view GltfFile::read_container() {
  if (!bytes_.starts_with(magic)) return bytes_;
  constexpr std::size_t header = 12, chunk_header = 8;
  const std::string_view all = bytes_;
  const auto refuse = [&](const std::string& what) {
    throw InputError(source_, "this GLB is damaged: " + what);
  };
  if (all.size() < header + chunk_header)
    refuse(fmt::format("it has {} bytes, and its headers alone have {}", all.size(), header + chunk_header));
  if (const auto version = little_endian(all.substr(4)); version != 2)
    throw InputError(source_, fmt::format("expected glTF version 2, found {}; save it as 2.0", version));
  const std::size_t length = little_endian(all.substr(8));
  if (length > all.size() || length < header)
    refuse(fmt::format("it says that it has {} bytes, and it has {}", length, all.size()));
  std::string_view text;
  auto rest = all.substr(header, length - header);
  for (int chunk = 0; rest.size() >= chunk_header; ++chunk) {
    const std::size_t size = little_endian(rest);
    const auto kind = little_endian(rest.substr(4));
    rest.remove_prefix(chunk_header);
    if (size > rest.size())
      refuse(fmt::format("chunk {} says that it has {} bytes, and {} are left", chunk, size, rest.size()));
    if (chunk == 0 && kind != json_chunk) refuse("its first chunk is not JSON");
    if (chunk == 0) text = rest.substr(0, size);
    if (chunk == 1 && kind == binary_chunk) binary_ = rest.substr(0, size);
    rest.remove_prefix(size);
  }
  if (!rest.empty()) refuse(fmt::format("{} bytes are left behind its last chunk", rest.size()));
  return text;
}

void GltfFile::check_version(const std::vector<std::string_view>& extensions) const {
  const auto asset = root_["asset"];
  const auto version = asset["version"].text();
  const auto least = asset["minVersion"].text(version);
  if (!version.starts_with("2.") || (asset["minVersion"] && least != "2.0"))
    asset.refuse(fmt::format("expected glTF 2.0, found {}", version.starts_with("2.") ? least : version));
  const auto required = root_["extensionsRequired"];
  for (std::size_t i = 0; i < required.size(); ++i) {
    const auto name = required[i].text();
    if (std::find(extensions.begin(), extensions.end(), name) == extensions.end())
      required[i].refuse(fmt::format(
          "the file cannot be read without {}, which Luxel lacks; export it without, for example by: npx "
          "@gltf-transform/cli copy IN.glb OUT.glb",
          name));
  }
}

JsonValue GltfFile::object(const JsonValue& index, std::string_view array) const {
  const auto all = root_[array];
  const auto number = index.whole();
  if (number >= all.size())
    index.refuse(fmt::format("it names number {} of the {}, but the file has {} (numbered from 0)", number,
                             array, all.size()));
  return all[number];
}

std::string_view GltfFile::view(const JsonValue& index) {
  object(index, "bufferViews");
  return view(index.whole());
}

std::string_view GltfFile::view(std::size_t number) { return range(root_["bufferViews"][number]); }

std::string_view GltfFile::range(const JsonValue& of) {
  object(of["buffer"], "buffers");
  const auto whole = buffer(of["buffer"].whole());
  const auto offset = of["byteOffset"].whole(0), length = of["byteLength"].whole();
  if (offset > whole.size() || length > whole.size() - offset)
    of.refuse(fmt::format("it takes {} bytes from byte {} on, but the buffer has {}", length, offset,
                          whole.size()));
  return whole.substr(offset, length);
}

std::string_view GltfFile::buffer(std::size_t number) {
  const auto buffer = root_["buffers"][number];
  const auto length = buffer["byteLength"].whole();
  std::string_view bytes = binary_;
  if (const auto found = buffers_.find(number); found != buffers_.end()) {
    bytes = found->second;
  } else if (const auto uri = buffer["uri"]) {
    bytes = buffers_[number] = resource(uri);
  } else if (number != 0) {
    buffer.refuse("expected a uri, found none; only the first buffer may lie inside the file");
  }
  if (bytes.size() < length)
    buffer.refuse(fmt::format("it says that it has {} bytes, and {} are there", length, bytes.size()));
  return bytes.substr(0, length);
}

std::string GltfFile::resource(const JsonValue& uri) {
  const auto text = uri.text();
  if (is_data_uri(text)) {
    auto bytes = data_of_uri(text);
    if (!bytes) uri.refuse("expected 'data:', a type and base64, found a damaged data URI");
    return std::move(*bytes);
  }
  const auto name = file_of_uri(text);
  if (!name)
    uri.refuse(fmt::format("expected the name of a file beside this one, found '{}'", text.substr(0, 60)));
  const auto found = permitted_.find(folder_, name->string());
  if (!found.file && !found.is_outside)
    uri.refuse(fmt::format("there is no file '{}'", (folder_ / *name).string()));
  if (!found.file)
    refuse_outside(fmt::format("{}: {}", source_, uri.path()), fmt::format("the file '{}'", name->string()));
  add_file(files_, *found.file);
  return read_file(*found.file);
}

}  // namespace luxel
