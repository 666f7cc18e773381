// SPDX-License-Identifier: Apache-2.0
// Compressed glTF files are the same scene as plain ones, and damaged ones are refused with one sentence.
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/import/load_gltf.h"
#include "luxel/scene/scene.h"

#include "support/scene_files.h"
#include "support/small_gltf.h"

#ifdef LUXEL_HAS_DRACO
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#endif
#ifdef LUXEL_HAS_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif
#ifdef LUXEL_HAS_WEBP
#include <webp/encode.h>
#endif

namespace luxel {
namespace {

// A bowl of 8 x 8 quads.
struct Bowl {
  static constexpr std::uint32_t side = 9;
  std::vector<float> positions, uvs;
  std::vector<std::uint32_t> indices;

  Bowl() {
    for (std::uint32_t y = 0; y < side; ++y)
      for (std::uint32_t x = 0; x < side; ++x) {
        const auto u = static_cast<float>(x) / 8.0f, v = static_cast<float>(y) / 8.0f;
        positions.insert(positions.end(), {u, v, (u - 0.5f) * (u - 0.5f) + (v - 0.5f) * (v - 0.5f)});
        uvs.insert(uvs.end(), {u, v});
        if (x + 1 == side || y + 1 == side) continue;
        const auto corner = y * side + x;
        for (const auto offset : {0u, 1u, side, 1u, side + 1, side}) indices.push_back(corner + offset);
      }
  }
  std::size_t vertices() const { return positions.size() / 3; }

  SmallGltf plain() const {
    SmallGltf gltf;
    gltf.points(positions);
    gltf.array(SmallGltf::f32, "VEC2", vertices(), uvs);
    gltf.array(SmallGltf::u32, "SCALAR", indices.size(), indices);
    gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]})";
    gltf.rest = materials;
    return gltf;
  }
  static constexpr const char* materials =
      R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.2,0.4,0.6,1],"metallicFactor":0}}])";
};

class LoadCompressedGltf : public testing::Test {
 protected:
  Scene load(const SmallGltf& gltf) {
    files_.write("room.gltf", gltf.text());
    auto scene = files_.load("room.gltf");
    check_scene(scene);
    return scene;
  }
  std::string refusal(const SmallGltf& gltf) {
    files_.write("room.gltf", gltf.text());
    return files_.refusal("room.gltf");
  }
  static void expect(const std::string& found, const std::string& words) {
    EXPECT_NE(found.find(words), std::string::npos) << found << "\nlacks: " << words;
    EXPECT_EQ(found.find('\n'), std::string::npos) << found;
  }
  // Every damage to the file is answered by a sound scene or by one sentence that names the file.
  static void expect_answers(const std::string& whole, std::size_t begin, std::size_t step) {
    std::size_t refused = 0;
    for (auto at = begin; at < whole.size(); at += step) {
      auto bytes = whole;
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << at % 8));
      try {
        check_scene(load_gltf(std::move(bytes), "room.glb", {}, {}));
      } catch (const InputError& error) {
        ++refused;
        EXPECT_EQ(std::string(error.what()).rfind("room.glb", 0), 0u) << error.what();
      }
    }
    EXPECT_GT(refused, 0u);
  }
  SceneFiles files_;
};

#ifdef LUXEL_HAS_DRACO

std::string draco_bytes(const Bowl& bowl, int method) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(static_cast<int>(bowl.indices.size() / 3));
  const auto position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const auto uv = builder.AddAttribute(draco::GeometryAttribute::TEX_COORD, 2, draco::DT_FLOAT32);
  for (std::size_t f = 0; f < bowl.indices.size() / 3; ++f) {
    const auto* corner = &bowl.indices[3 * f];
    const auto put = [&](int attribute, const std::vector<float>& values, std::size_t n) {
      builder.SetAttributeValuesForFace(attribute, draco::FaceIndex(static_cast<std::uint32_t>(f)),
                                        &values[n * corner[0]], &values[n * corner[1]],
                                        &values[n * corner[2]]);
    };
    put(position, bowl.positions, 3);
    put(uv, bowl.uvs, 2);
  }
  const auto mesh = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  if (method == draco::MESH_EDGEBREAKER_ENCODING)
    encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  return {buffer.data(), buffer.size()};
}

SmallGltf with_draco(const Bowl& bowl, const std::string& bytes) {
  SmallGltf gltf;
  const auto view = gltf.view(bytes);
  gltf.accessor(SmallGltf::f32, "VEC3", bowl.vertices(), "");
  gltf.accessor(SmallGltf::f32, "VEC2", bowl.vertices(), "");
  gltf.accessor(SmallGltf::u32, "SCALAR", bowl.indices.size(), "");
  gltf.meshes = fmt::format(
      R"({{"primitives":[{{"attributes":{{"POSITION":0,"TEXCOORD_0":1}},"indices":2,"material":0,)"
      R"("extensions":{{"KHR_draco_mesh_compression":{{"bufferView":{},)"
      R"("attributes":{{"POSITION":0,"TEXCOORD_0":1}}}}}}}}]}})",
      view);
  gltf.rest = std::string(Bowl::materials) + R"(,"extensionsUsed":["KHR_draco_mesh_compression"],)" +
              R"("extensionsRequired":["KHR_draco_mesh_compression"])";
  return gltf;
}

double area_of(const Scene& scene) {
  double area = 0.0;
  for (const auto& t : scene.triangles)
    area += 0.5 * glm::length(glm::cross(scene.positions[t[1]] - scene.positions[t[0]],
                                         scene.positions[t[2]] - scene.positions[t[0]]));
  return area;
}

TEST_F(LoadCompressedGltf, draco_without_loss_is_the_same_scene) {
  const Bowl bowl;
  const auto plain = load(bowl.plain());
  const auto scene = load(with_draco(bowl, draco_bytes(bowl, draco::MESH_SEQUENTIAL_ENCODING)));
  ASSERT_EQ(scene.triangles.size(), 128u);
  EXPECT_EQ(scene.positions.size(), plain.positions.size());
  for (std::size_t t = 0; t < scene.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(scene.positions[scene.triangles[t][k]], plain.positions[plain.triangles[t][k]]);
  EXPECT_EQ(scene.materials[0].reflectance, plain.materials[0].reflectance);
  EXPECT_TRUE(files_.warnings().empty()) << files_.all_warnings();
}

TEST_F(LoadCompressedGltf, draco_with_14_bits_is_the_same_surface) {
  const Bowl bowl;
  const auto scene = load(with_draco(bowl, draco_bytes(bowl, draco::MESH_EDGEBREAKER_ENCODING)));
  EXPECT_EQ(scene.triangles.size(), 128u);
  EXPECT_NEAR(area_of(scene), area_of(load(bowl.plain())), 1e-3);
}

TEST_F(LoadCompressedGltf, a_mesh_that_is_there_uncompressed_too_is_read_so) {
  const Bowl bowl;
  auto gltf = bowl.plain();
  const auto at = gltf.meshes.find(R"("material":0)");
  gltf.meshes.insert(at, R"("extensions":{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{}}},)");
  EXPECT_EQ(fingerprint(load(gltf)), fingerprint(load(bowl.plain())));
}

TEST_F(LoadCompressedGltf, damaged_draco_is_one_sentence) {
  const Bowl bowl;
  const auto bytes = draco_bytes(bowl, draco::MESH_EDGEBREAKER_ENCODING);
  expect(refusal(with_draco(bowl, bytes.substr(0, bytes.size() / 2))),
         "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression: its Draco data is damaged (");
  expect(refusal(with_draco(bowl, "no Draco at all")), "its Draco data is damaged (");
  expect(refusal(with_draco(bowl, "")), "its Draco data is damaged (");
  auto lacking = with_draco(bowl, bytes);
  lacking.meshes.replace(lacking.meshes.rfind(R"("TEXCOORD_0":1)"), 14, R"("TEXCOORD_0":7)");
  expect(refusal(lacking), "it has no attribute 7");
  const auto whole = with_draco(bowl, bytes).glb();
  expect_answers(whole, whole.size() - bytes.size(), 1);
}

TEST_F(LoadCompressedGltf, draco_that_declares_more_than_it_can_hold_is_refused_before_it_takes_memory) {
  const Bowl bowl;
  auto bytes = draco_bytes(bowl, draco::MESH_SEQUENTIAL_ENCODING);
  // The counts of triangles and vertices are variable-length numbers behind 11 bytes of header.
  bytes.replace(11, 3, "\xff\xff\xff\xff\x0f\xff\xff\xff\xff\x0f");
  expect(refusal(with_draco(bowl, bytes)), "4294967295 triangles");
}

#endif
#ifdef LUXEL_HAS_MESHOPTIMIZER

struct MeshoptArray {
  std::string bytes;
  std::size_t count, stride;
  const char* mode;
};

template <typename T>
MeshoptArray attribute(const std::vector<T>& values, std::size_t components) {
  const auto stride = components * sizeof(T), count = values.size() / components;
  std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(count, stride));
  meshopt_encodeVertexVersion(0);
  bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), values.data(), count, stride));
  return {bytes_of(bytes), count, stride, "ATTRIBUTES"};
}

MeshoptArray triangles(const std::vector<std::uint32_t>& indices, std::size_t vertices, bool as_sequence) {
  meshopt_encodeIndexVersion(1);
  std::vector<unsigned char> bytes(as_sequence ? meshopt_encodeIndexSequenceBound(indices.size(), vertices)
                                               : meshopt_encodeIndexBufferBound(indices.size(), vertices));
  const auto* from = indices.data();
  bytes.resize(as_sequence ? meshopt_encodeIndexSequence(bytes.data(), bytes.size(), from, indices.size())
                           : meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), from, indices.size()));
  return {bytes_of(bytes), indices.size(), 4, as_sequence ? "INDICES" : "TRIANGLES"};
}

// A file whose views are compressed, with a second buffer that stands for the uncompressed ones.
SmallGltf with_meshopt(const std::array<MeshoptArray, 3>& arrays) {
  SmallGltf gltf;
  std::size_t fallback = 0;
  for (const auto& [bytes, count, stride, mode] : arrays) {
    gltf.buffer.resize((gltf.buffer.size() + 3) / 4 * 4);
    gltf.views += fmt::format(
        R"({}{{"buffer":1,"byteOffset":{},"byteLength":{}{},"extensions":{{"EXT_meshopt_compression":)"
        R"({{"buffer":0,"byteOffset":{},"byteLength":{},"byteStride":{},"count":{},"mode":"{}"}}}}}})",
        gltf.view_count > 0 ? "," : "", fallback, count * stride,
        mode == std::string("ATTRIBUTES") ? fmt::format(R"(,"byteStride":{})", stride) : "",
        gltf.buffer.size(), bytes.size(), stride, count, mode);
    fallback += count * stride;
    gltf.buffer += bytes;
    ++gltf.view_count;
  }
  gltf.accessor(SmallGltf::f32, "VEC3", arrays[0].count, R"("bufferView":0)");
  gltf.accessor(SmallGltf::f32, "VEC2", arrays[1].count, R"("bufferView":1)");
  gltf.accessor(SmallGltf::u32, "SCALAR", arrays[2].count, R"("bufferView":2)");
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"indices":2,"material":0}]})";
  gltf.rest = std::string(Bowl::materials) + R"(,"extensionsUsed":["EXT_meshopt_compression"],)" +
              R"("extensionsRequired":["EXT_meshopt_compression"])";
  return gltf;
}

// The JSON of such a file declares the second buffer too.
std::string glb_of(const SmallGltf& gltf) {
  auto whole = gltf.glb();
  auto text = gltf.json("");
  const auto at = text.find("}],\"bufferViews\"");
  text.insert(at + 1, R"(,{"byteLength":99999,"extensions":{"EXT_meshopt_compression":{"fallback":true}}})");
  text.resize((text.size() + 3) / 4 * 4, ' ');
  auto bytes = gltf.buffer;
  bytes.resize((bytes.size() + 3) / 4 * 4);
  const auto number = [](std::size_t n) { return bytes_of(std::vector{static_cast<std::uint32_t>(n)}); };
  return "glTF" + number(2) + number(28 + text.size() + bytes.size()) + number(text.size()) + "JSON" + text +
         number(bytes.size()) + std::string("BIN\0", 4) + bytes;
}

class LoadMeshopt : public LoadCompressedGltf {
 protected:
  Scene load_glb(const SmallGltf& gltf) {
    files_.write("room.glb", glb_of(gltf));
    return files_.load("room.glb");
  }
  std::string refusal_of_glb(const SmallGltf& gltf) {
    files_.write("room.glb", glb_of(gltf));
    return files_.refusal("room.glb");
  }
  const Bowl bowl_;
  std::array<MeshoptArray, 3> arrays_ = {attribute(bowl_.positions, 3), attribute(bowl_.uvs, 2),
                                         triangles(bowl_.indices, bowl_.vertices(), true)};
};

TEST_F(LoadMeshopt, compressed_arrays_are_the_same_scene) {
  EXPECT_EQ(fingerprint(load_glb(with_meshopt(arrays_))), fingerprint(load(bowl_.plain())));
}

TEST_F(LoadMeshopt, compressed_triangles_are_the_same_surface) {
  arrays_[2] = triangles(bowl_.indices, bowl_.vertices(), false);
  const auto plain = load(bowl_.plain()), scene = load_glb(with_meshopt(arrays_));
  ASSERT_EQ(scene.triangles.size(), plain.triangles.size());
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {  // the code may rotate the corners
    const auto& of = plain.triangles[t];
    const auto first = plain.positions[of[0]];
    std::size_t k = 0;
    while (k < 3 && scene.positions[scene.triangles[t][k]] != first) ++k;
    ASSERT_LT(k, 3u);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(scene.positions[scene.triangles[t][(k + i) % 3]], plain.positions[of[i]]);
  }
}

TEST_F(LoadMeshopt, damaged_arrays_are_one_sentence) {
  auto cut = arrays_;
  cut[0].bytes.resize(cut[0].bytes.size() / 2);
  expect(refusal_of_glb(with_meshopt(cut)),
         "/bufferViews/0/extensions/EXT_meshopt_compression: its meshopt data is damaged (it cannot be "
         "decoded)");
  auto mode = arrays_;
  mode[1].mode = "ELEMENTS";
  expect(refusal_of_glb(with_meshopt(mode)),
         "expected the mode ATTRIBUTES, TRIANGLES or INDICES, found 'ELEMENTS'");
  auto stride = arrays_;
  stride[1].stride = 7;
  expect(refusal_of_glb(with_meshopt(stride)), "elements of 7 bytes");
  auto filter = with_meshopt(arrays_);
  filter.views.replace(filter.views.find(R"("mode":"ATTRIBUTES")"), 19,
                       R"("mode":"ATTRIBUTES","filter":"QUATERNION")");
  expect(refusal_of_glb(filter), "the filter QUATERNION of elements of 12 bytes");
  const auto whole = glb_of(with_meshopt(arrays_));
  expect_answers(whole, whole.size() - with_meshopt(arrays_).buffer.size(), 1);
}

TEST_F(LoadMeshopt, more_elements_than_so_many_bytes_can_hold_are_refused_before_they_take_memory) {
  arrays_[0].count = 1'000'000'000'000;
  expect(refusal_of_glb(with_meshopt(arrays_)), "1000000000000 elements of 12 bytes in");
}

#endif
#ifdef LUXEL_HAS_WEBP

// A bowl whose material has a picture of 2 x 2 colours, without loss.
SmallGltf with_webp(std::string& bytes) {
  const std::array<std::uint8_t, 16> rgba = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 99, 99, 99, 255};
  std::uint8_t* encoded = nullptr;
  const auto size = WebPEncodeLosslessRGBA(rgba.data(), 2, 2, 8, &encoded);
  if (bytes.empty()) bytes.assign(reinterpret_cast<const char*>(encoded), size);
  WebPFree(encoded);
  auto gltf = Bowl().plain();
  const auto view = gltf.view(bytes);
  gltf.rest = fmt::format(
      R"(,"materials":[{{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":0}},"metallicFactor":0}}}}],)"
      R"("textures":[{{"extensions":{{"EXT_texture_webp":{{"source":0}}}}}}],)"
      R"("images":[{{"bufferView":{},"mimeType":"image/webp"}}],)"
      R"("extensionsUsed":["EXT_texture_webp"],"extensionsRequired":["EXT_texture_webp"])",
      view);
  return gltf;
}

TEST_F(LoadCompressedGltf, webp_pictures_are_read) {
  std::string bytes;
  const auto scene = load(with_webp(bytes));
  EXPECT_TRUE(files_.warnings().empty()) << files_.all_warnings();
  ASSERT_EQ(scene.textures.size(), 1u);
  const auto& raster = *scene.textures[0].raster;
  ASSERT_EQ(raster.codes.size(), 4u);
  EXPECT_EQ(raster.codes[0], (Raster::Code{255, 0, 0, 255}));
  EXPECT_EQ(raster.codes[3], (Raster::Code{99, 99, 99, 255}));
}

TEST_F(LoadCompressedGltf, damaged_webp_is_a_warning) {
  std::string bytes;
  with_webp(bytes);
  for (auto cut = bytes.substr(0, bytes.size() - 8); cut.size() > 12; cut.resize(cut.size() - 5)) {
    load(with_webp(cut));
    ASSERT_EQ(files_.warnings().size(), 1u);
    expect(files_.warnings()[0], "the picture is damaged");
  }
}

#endif

TEST_F(LoadCompressedGltf, ktx2_pictures_are_a_warning_that_names_the_command) {
  auto gltf = Bowl().plain();
  const auto view = gltf.view("\xabKTX 20\xbb\r\n\x1a\n");
  gltf.rest = fmt::format(
      R"(,"materials":[{{"pbrMetallicRoughness":{{"baseColorTexture":{{"index":0}},"metallicFactor":0}}}}],)"
      R"("textures":[{{"extensions":{{"KHR_texture_basisu":{{"source":0}}}}}}],)"
      R"("images":[{{"bufferView":{},"mimeType":"image/ktx2"}}],)"
      R"("extensionsUsed":["KHR_texture_basisu"],"extensionsRequired":["KHR_texture_basisu"])",
      view);
  const auto scene = load(gltf);
  EXPECT_EQ(scene.triangles.size(), 128u);
  ASSERT_EQ(files_.warnings().size(), 1u);
  expect(files_.warnings()[0],
         "KTX2, which Luxel does not read; convert the file by: npx @gltf-transform/cli "
         "ktxdecompress IN.glb OUT.glb");
}

}  // namespace
}  // namespace luxel
