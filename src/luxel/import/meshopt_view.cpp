// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/meshopt_view.h"

#include <fmt/format.h>

#include "luxel/import/draco_mesh.h"

#ifdef LUXEL_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

namespace luxel {

#ifndef LUXEL_HAS_MESHOPTIMIZER

std::string decode_meshopt(std::string_view, const MeshoptView&) {
  throw CompressionError(
      "its arrays are compressed by meshoptimizer, and this luxel was built without it; install "
      "libmeshoptimizer-dev and build again, or expand the file: npx @gltf-transform/cli copy IN.glb "
      "OUT.glb");
}

#else

namespace {

// The densest code of the format: 256 equal bytes take 4; an index takes a third of a byte or more.
constexpr std::size_t max_expansion = 64;
constexpr std::size_t max_stride = 256;

[[noreturn]] void refuse(const std::string& reason) {
  throw CompressionError(
      fmt::format("its meshopt data is damaged ({}); export the file anew, or without compression", reason));
}

void check(std::string_view bytes, const MeshoptView& view) {
  const bool is_attribute = view.mode == "ATTRIBUTES";
  if (!is_attribute && view.mode != "TRIANGLES" && view.mode != "INDICES")
    refuse(fmt::format("expected the mode ATTRIBUTES, TRIANGLES or INDICES, found '{}'", view.mode));
  if (is_attribute ? view.stride < 4 || view.stride > max_stride || view.stride % 4 != 0
                   : view.stride != 2 && view.stride != 4)
    refuse(fmt::format("elements of {} bytes", view.stride));
  if (view.mode == "TRIANGLES" && view.count % 3 != 0) refuse(fmt::format("{} corners", view.count));
  if (view.count / max_expansion > (bytes.size() + max_stride) / view.stride)
    refuse(fmt::format("{} elements of {} bytes in {}", view.count, view.stride, bytes.size()));
}

void apply_filter(std::string& decoded, const MeshoptView& view) {
  const auto expect_stride = [&](std::size_t a, std::size_t b) {
    if (view.stride != a && view.stride != b)
      refuse(fmt::format("the filter {} of elements of {} bytes", view.filter, view.stride));
  };
  if (view.filter == "OCTAHEDRAL") {
    expect_stride(4, 8);
    meshopt_decodeFilterOct(decoded.data(), view.count, view.stride);
  } else if (view.filter == "QUATERNION") {
    expect_stride(8, 8);
    meshopt_decodeFilterQuat(decoded.data(), view.count, view.stride);
  } else if (view.filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(decoded.data(), view.count, view.stride);
  } else if (view.filter != "NONE") {
    refuse(fmt::format("expected the filter NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL, found '{}'",
                       view.filter));
  }
}

}  // namespace

std::string decode_meshopt(std::string_view bytes, const MeshoptView& view) {
  check(bytes, view);
  if (view.count == 0) return {};
  std::string decoded(view.count * view.stride, '\0');
  const auto* from = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto failed =
      view.mode == "ATTRIBUTES"
          ? meshopt_decodeVertexBuffer(decoded.data(), view.count, view.stride, from, bytes.size())
      : view.mode == "TRIANGLES"
          ? meshopt_decodeIndexBuffer(decoded.data(), view.count, view.stride, from, bytes.size())
          : meshopt_decodeIndexSequence(decoded.data(), view.count, view.stride, from, bytes.size());
  if (failed) refuse("it cannot be decoded");
  apply_filter(decoded, view);
  return decoded;
}

#endif

}  // namespace luxel
