// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/meshopt_encode.h"

#include <cstring>

#include <fmt/format.h>

#include "luxel/core/error.h"
#include "luxel/core/none.h"

#ifdef LUXEL_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

namespace luxel {

#ifndef LUXEL_HAS_MESHOPTIMIZER

namespace {
[[noreturn]] void refuse() {
  throw InputError(
      "meshes cannot be compressed by meshoptimizer, because this luxel was built without it; install "
      "libmeshoptimizer-dev and build again");
}
}  // namespace

bool has_meshopt() { return false; }
MeshOrder meshopt_order(const std::vector<std::array<std::uint32_t, 3>>&, std::size_t) { refuse(); }
std::string encode_meshopt(std::string_view, const MeshoptView&) { refuse(); }

#else

namespace {

constexpr int mantissa_bits = 13;                     // with the sign
constexpr int index_version = 1, vertex_version = 0;  // those of EXT_meshopt_compression

std::vector<unsigned> indices_of(std::string_view bytes, std::size_t stride) {
  std::vector<unsigned> indices(bytes.size() / stride);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    std::uint32_t index = 0;
    std::memcpy(&index, bytes.data() + i * stride, stride);  // little-endian, as the host
    indices[i] = index;
  }
  return indices;
}

std::string encoded_indices(std::string_view bytes, const MeshoptView& view) {
  const auto indices = indices_of(bytes, view.stride);
  const bool is_list = view.mode == "TRIANGLES";
  constexpr std::size_t any_vertex = none;
  std::string code(is_list ? meshopt_encodeIndexBufferBound(indices.size(), any_vertex)
                           : meshopt_encodeIndexSequenceBound(indices.size(), any_vertex),
                   '\0');
  meshopt_encodeIndexVersion(index_version);
  auto* to = reinterpret_cast<unsigned char*>(code.data());
  code.resize(is_list ? meshopt_encodeIndexBuffer(to, code.size(), indices.data(), indices.size())
                      : meshopt_encodeIndexSequence(to, code.size(), indices.data(), indices.size()));
  return code;
}

// The encoder reads floats, aligned.
std::string filtered(std::string_view bytes, const MeshoptView& view) {
  std::vector<float> values(bytes.size() / sizeof(float));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  std::string result(bytes.size(), '\0');
  meshopt_encodeFilterExp(result.data(), view.count, view.stride, mantissa_bits, values.data());
  return result;
}

}  // namespace

bool has_meshopt() { return true; }

MeshOrder meshopt_order(const std::vector<std::array<std::uint32_t, 3>>& triangles, std::size_t vertices) {
  MeshOrder order;
  order.triangles.resize(triangles.size());
  if (triangles.empty()) return order;
  const auto count = 3 * triangles.size();
  auto* indices = order.triangles.front().data();
  meshopt_optimizeVertexCacheStrip(indices, triangles.front().data(), count, vertices);
  std::vector<unsigned> number(vertices);
  order.vertices.resize(meshopt_optimizeVertexFetchRemap(number.data(), indices, count, vertices));
  for (std::size_t v = 0; v < vertices; ++v)
    if (number[v] != none) order.vertices[number[v]] = static_cast<std::uint32_t>(v);
  for (auto& triangle : order.triangles)
    for (auto& index : triangle) index = number[index];
  return order;
}

std::string encode_meshopt(std::string_view bytes, const MeshoptView& view) {
  if (view.mode != "ATTRIBUTES") return encoded_indices(bytes, view);
  std::string exponential;
  if (view.filter == "EXPONENTIAL") {
    exponential = filtered(bytes, view);
    bytes = exponential;
  } else if (view.filter != "NONE") {
    throw InputError(fmt::format("the filter {} is not written", view.filter));
  }
  std::string code(meshopt_encodeVertexBufferBound(view.count, view.stride), '\0');
  meshopt_encodeVertexVersion(vertex_version);
  code.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(code.data()), code.size(),
                                         bytes.data(), view.count, view.stride));
  return code;
}

#endif

}  // namespace luxel
