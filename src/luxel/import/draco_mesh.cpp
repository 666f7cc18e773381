// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/draco_mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <new>

#include <fmt/format.h>

#ifdef LUXEL_HAS_DRACO
#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#endif

namespace luxel {

std::size_t draco_stride(const DracoColumn& column) {
  const auto size = column.component <= 5121 ? 1 : column.component <= 5123 ? 2 : 4;
  return (column.components * static_cast<std::size_t>(size) + 3) / 4 * 4;
}

#ifndef LUXEL_HAS_DRACO

DracoMesh decode_draco(std::string_view, std::span<const DracoColumn>) {
  throw CompressionError(
      "its mesh is compressed by Draco, and this luxel was built without it; install libdraco-dev and build "
      "again, or expand the file: npx @gltf-transform/cli copy IN.glb OUT.glb");
}

#else

namespace {

// Real meshes have at most about 60 triangles per byte (a flat grid); the excess allows for small ones.
constexpr std::uint64_t max_faces_per_byte = 200, faces_allowed = 10'000;
constexpr std::uint64_t max_faces = 100'000'000;

[[noreturn]] void refuse_damaged(const std::string& reason) {
  throw CompressionError(
      fmt::format("its Draco data is damaged ({}); export the file anew, or without compression", reason));
}

// Draco allocates what the header declares, so that is compared with the size of the data first.
void check_header(std::string_view bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::DracoHeader header;
  if (const auto status = draco::PointCloudDecoder::DecodeHeader(&buffer, &header); !status.ok())
    refuse_damaged(status.error_msg_string());
  if (header.encoder_type != draco::TRIANGULAR_MESH) refuse_damaged("it is no mesh of triangles");
  if (header.version_major != 2 || header.version_minor != 2)
    refuse_damaged(
        fmt::format("expected version 2.2, found {}.{}", header.version_major, header.version_minor));
  buffer.set_bitstream_version(
      static_cast<std::uint16_t>(DRACO_BITSTREAM_VERSION(header.version_major, header.version_minor)));
  if (header.flags & METADATA_FLAG_MASK) {
    draco::GeometryMetadata metadata;
    if (!draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata)) refuse_damaged("its metadata");
  }
  std::uint8_t traversal = 0;
  const bool is_edgebreaker = header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING;
  std::uint32_t first = 0, second = 0;
  if ((is_edgebreaker && !buffer.Decode(&traversal)) || !draco::DecodeVarint(&first, &buffer) ||
      !draco::DecodeVarint(&second, &buffer))
    refuse_damaged("it ends in its header");
  const std::uint64_t faces = is_edgebreaker ? second : first, points = is_edgebreaker ? first : second;
  const auto limit = std::min(max_faces, faces_allowed + max_faces_per_byte * bytes.size());
  if (faces > limit || points > 3 * limit)
    refuse_damaged(fmt::format("{} triangles and {} vertices in {} bytes", faces, points, bytes.size()));
}

template <typename T>
void convert(const draco::PointAttribute& attribute, std::size_t vertices, const DracoColumn& column,
             std::string& bytes) {
  const auto stride = draco_stride(column);
  bytes.assign(vertices * stride, '\0');
  for (std::size_t v = 0; v < vertices; ++v) {
    std::array<T, 4> values{};
    const auto place = attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(v)));
    if (place.value() >= attribute.size() ||
        !attribute.ConvertValue<T>(place, static_cast<std::int8_t>(column.components), values.data()))
      refuse_damaged(fmt::format("attribute {}", column.id));
    std::memcpy(bytes.data() + v * stride, values.data(), column.components * sizeof(T));
  }
}

std::string column_of(const draco::Mesh& mesh, const DracoColumn& column) {
  const auto* attribute = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(column.id));
  if (!attribute) refuse_damaged(fmt::format("it has no attribute {}", column.id));
  std::string bytes;
  switch (column.component) {
    case 5120:
      convert<std::int8_t>(*attribute, mesh.num_points(), column, bytes);
      break;
    case 5121:
      convert<std::uint8_t>(*attribute, mesh.num_points(), column, bytes);
      break;
    case 5122:
      convert<std::int16_t>(*attribute, mesh.num_points(), column, bytes);
      break;
    case 5123:
      convert<std::uint16_t>(*attribute, mesh.num_points(), column, bytes);
      break;
    case 5125:
      convert<std::uint32_t>(*attribute, mesh.num_points(), column, bytes);
      break;
    default:
      convert<float>(*attribute, mesh.num_points(), column, bytes);
  }
  return bytes;
}

DracoMesh decode(std::string_view bytes, std::span<const DracoColumn> columns) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) {
    const auto reason = decoded.status().error_msg_string();
    refuse_damaged(reason.empty() ? "it cannot be decoded" : reason);
  }
  const auto& mesh = *decoded.value();
  DracoMesh found;
  found.vertices = mesh.num_points();
  for (draco::FaceIndex f(0); f < mesh.num_faces(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto index = mesh.face(f)[k].value();
      if (index >= found.vertices) refuse_damaged("an index beyond its vertices");
      found.indices.push_back(index);
    }
  for (const auto& column : columns) found.columns.push_back(column_of(mesh, column));
  return found;
}

}  // namespace

DracoMesh decode_draco(std::string_view bytes, std::span<const DracoColumn> columns) {
  check_header(bytes);
  try {
    return decode(bytes, columns);
  } catch (const std::bad_alloc&) {
    refuse_damaged("it declares more than fits into memory");
  } catch (const std::length_error&) {
    refuse_damaged("it declares more than fits into memory");
  }
}

#endif

}  // namespace luxel
