// SPDX-License-Identifier: Apache-2.0
// glTF files that are wrong: each is refused with one sentence that names the place.
#include <cstdint>

#include <gtest/gtest.h>

#include "luxel/scene/scene.h"

#include "support/scene_files.h"
#include "support/small_gltf.h"

namespace luxel {
namespace {

class LoadGltfDamaged : public testing::Test {
 protected:
  std::string refusal(const std::string& text) {
    files_.write("room.gltf", text);
    return files_.refusal("room.gltf");
  }
  std::string refusal(const SmallGltf& gltf) { return refusal(gltf.text()); }
  // The error for a file of one triangle whose JSON has one part replaced.
  std::string refusal_with(const std::string& part, const std::string& by) {
    auto text = indexed().text();
    const auto at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    if (at != std::string::npos) text.replace(at, part.size(), by);
    return refusal(text);
  }
  static SmallGltf indexed() {
    auto gltf = one_triangle();
    gltf.array<std::uint16_t>(SmallGltf::u16, "SCALAR", 3, {0, 1, 2});
    gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"indices":1}]})";
    return gltf;
  }
  void expect(const std::string& found, const std::string& words) {
    EXPECT_NE(found.find(words), std::string::npos) << found << "\nlacks: " << words;
    EXPECT_NE(found.find("room."), std::string::npos) << found;
    EXPECT_EQ(found.find('\n'), std::string::npos) << found;
  }
  SceneFiles files_;
};

TEST_F(LoadGltfDamaged, the_undamaged_file_loads) {
  EXPECT_EQ(refusal(indexed()), "loaded without complaint");
}

TEST_F(LoadGltfDamaged, what_is_no_json_is_refused_with_its_line) {
  expect(refusal(""), "room.gltf:1: expected JSON");
  expect(refusal("{\n\n\"asset\": }"), "room.gltf:3: expected JSON");
  expect(refusal("{\"asset\":{\"version\":1e999}}"), "expected JSON with numbers");
  expect(refusal("\xff\xfe{}"), "expected JSON");
  expect(refusal("[]"), "/: expected an object, found an array of 0");
  expect(refusal(std::string(200000, '[')), "expected JSON");
}

TEST_F(LoadGltfDamaged, deep_nesting_is_no_danger) {
  auto gltf = one_triangle();
  gltf.rest = R"(,"extras":)" + std::string(100000, '[') + std::string(100000, ']');
  EXPECT_EQ(refusal(gltf), "loaded without complaint");
}

TEST_F(LoadGltfDamaged, other_versions_and_unknown_extensions_are_refused) {
  expect(refusal_with(R"("version":"2.0")", R"("version":"1.0")"), "/asset: expected glTF 2.0, found 1.0");
  expect(refusal_with(R"("version":"2.0")", R"("version":"2.1","minVersion":"2.1")"), "found 2.1");
  expect(refusal("{}"), "/asset/version: expected a text, found nothing");
  auto gltf = one_triangle();
  gltf.rest = R"(,"extensionsRequired":["KHR_texture_transform","KHR_gaussian_splatting"])";
  expect(refusal(gltf), "/extensionsRequired/1: the file cannot be read without KHR_gaussian_splatting");
}

TEST_F(LoadGltfDamaged, a_scene_without_triangles_is_refused) {
  expect(refusal(R"({"asset":{"version":"2.0"}})"), "no triangles found");
  auto gltf = one_triangle();
  gltf.nodes = R"({"name":"empty"})";
  expect(refusal(gltf), "no triangles found in the 1 node of its scene");
}

TEST_F(LoadGltfDamaged, a_binary_file_must_be_as_long_as_it_says) {
  const auto whole = indexed().glb();
  const auto refused = [&](const std::string& bytes) {
    files_.write("room.glb", bytes);
    return files_.refusal("room.glb");
  };
  EXPECT_EQ(refused(whole), "loaded without complaint");
  EXPECT_EQ(refused(whole + "more"), "loaded without complaint");
  for (std::size_t size = 4; size < whole.size(); size += 7)
    expect(refused(whole.substr(0, size)), "room.glb: ");
  auto version = whole;
  version[4] = 1;
  expect(refused(version), "expected glTF version 2, found 1");
  auto chunk = whole;
  chunk[15] = 0x7f;
  expect(refused(chunk), "chunk 0 says that it has");
  auto kind = whole;
  kind[16] = 'X';
  expect(refused(kind), "its first chunk is not JSON");
}

TEST_F(LoadGltfDamaged, indices_that_lead_nowhere_are_named) {
  expect(refusal_with(R"("mesh":0)", R"("mesh":7)"),
         "/nodes/0/mesh: it names number 7 of the meshes, but the file has 1");
  expect(refusal_with(R"("POSITION":0)", R"("POSITION":9)"),
         "/meshes/0/primitives/0/attributes/POSITION: it names number 9");
  expect(refusal_with(R"("indices":1)", R"("indices":-1)"),
         "/meshes/0/primitives/0/indices: expected a whole number");
  expect(refusal_with(R"("indices":1)", R"("indices":"one")"), "found \"one\"");
  expect(refusal_with(R"("indices":1)", R"("indices":4294967297)"), "it names number 4294967297");
  expect(refusal_with(R"("bufferView":0)", R"("bufferView":5)"),
         "/accessors/0/bufferView: it names number 5");
  expect(refusal_with(R"("buffer":0)", R"("buffer":3)"), "/bufferViews/0/buffer: it names number 3");
  auto gltf = one_triangle();
  gltf.rest = R"(,"scene":4)";
  expect(refusal(gltf), "/scene: it names number 4 of the scenes, but the file has 0");
  gltf.rest = "";
  gltf.meshes = R"({"primitives":[{"material":2,"attributes":{"POSITION":0}}]})";
  expect(refusal(gltf), "/meshes/0/primitives/0/material: it names number 2");
}

TEST_F(LoadGltfDamaged, an_index_beyond_the_vertices_is_named) {
  auto gltf = one_triangle();
  gltf.array<std::uint16_t>(SmallGltf::u16, "SCALAR", 3, {0, 1, 3});
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"indices":1}]})";
  expect(refusal(gltf), "/meshes/0/primitives/0/indices: index 2 names vertex 3, but there are only 3");
}

TEST_F(LoadGltfDamaged, arrays_that_say_more_than_the_file_holds_are_refused) {
  expect(refusal_with(R"("count":3)", R"("count":4)"), "/accessors/0: 4 elements of 12 bytes");
  expect(refusal_with(R"("count":3)", R"("count":4000000000)"), "/accessors/0: 4000000000 elements");
  expect(refusal_with(R"("count":3)", R"("count":18446744073709551615)"),
         "/accessors/0: 18446744073709551615 elements");
  expect(refusal_with(R"("count":3,"bufferView":0)", R"("count":4000000000)"), "no bufferView");
  expect(refusal_with(R"("count":3)", R"("count":3,"byteOffset":1)"), "/accessors/0: 3 elements");
  expect(refusal_with(R"("count":3)", R"("count":3,"byteOffset":18446744073709551615)"),
         "/accessors/0: 3 elements");
  expect(refusal_with(R"("byteLength":36)", R"("byteLength":999)"),
         "/bufferViews/0: it takes 999 bytes from byte 0 on");
  expect(refusal_with(R"("byteOffset":0)", R"("byteOffset":18446744073709551600)"),
         "/bufferViews/0: it takes 36 bytes");
  expect(refusal_with(R"("byteLength":42)", R"("byteLength":43)"),
         "/buffers/0: it says that it has 43 bytes, and 42 are there");
  expect(refusal_with(R"("byteLength":36)", R"("byteLength":36,"byteStride":8)"),
         "/bufferViews/0/byteStride: expected 12 to 252 bytes");
  expect(refusal_with(R"("byteLength":36)", R"("byteLength":36,"byteStride":24)"), "24 bytes apart");
}

TEST_F(LoadGltfDamaged, what_few_bytes_say_many_times_is_bounded_by_the_sum) {
  auto gltf = one_triangle();
  const auto nodes = [](int count) {
    std::string text = R"({"mesh":0})";
    for (int i = 1; i < count; ++i) text += R"(,{"mesh":0})";
    return text;
  };
  // A million zeros are taken once, not twice.
  gltf.accessor(SmallGltf::u32, "SCALAR", 1'000'002, "");
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"indices":1}]})";
  gltf.nodes = nodes(2);
  expect(refusal(gltf),
         "/meshes/0/primitives/0: arrays without a bufferView have more than 1048576 elements");
  // Bytes that are there, many times.
  auto many = one_triangle();
  std::vector<std::uint8_t> indices(300'000);
  many.array<std::uint8_t>(SmallGltf::u8, "SCALAR", indices.size(), indices);
  many.meshes = R"({"primitives":[{"attributes":{"POSITION":0},"indices":1}]})";
  many.nodes = nodes(1001);
  expect(refusal(many), "/meshes/0/primitives/0: expected at most 300000000 corners");
}

TEST_F(LoadGltfDamaged, arrays_of_another_kind_are_refused) {
  expect(refusal_with(R"("VEC3")", R"("VEC2")"), "expected an accessor of 3 numbers an element, found 2");
  expect(refusal_with(R"("VEC3")", R"("MAT4")"), "/accessors/0/type: expected SCALAR, VEC2, VEC3 or VEC4");
  expect(refusal_with("5126", "5124"), "/accessors/0/componentType: expected one of the types");
  expect(refusal_with("5123", "5122"), "expected whole numbers without sign");
  expect(refusal_with(R"("attributes":{"POSITION":0})", R"("attributes":{"POSITION":0},"mode":9)"),
         "/meshes/0/primitives/0/mode: expected a mode");
  expect(refusal_with(R"("count":3,"bufferView":1)", R"("count":2,"bufferView":1)"),
         "expected three corners a triangle, found 2");
}

TEST_F(LoadGltfDamaged, sparse_elements_must_lie_in_their_array) {
  const auto sparse = [](const std::vector<std::uint8_t>& which, const std::string& count) {
    SmallGltf gltf;
    const auto indices = gltf.view(bytes_of(which));
    const auto values = gltf.view(bytes_of(std::vector<float>{1, 0, 0, 0, 1, 0}));
    gltf.accessor(SmallGltf::f32, "VEC3", 3,
                  fmt::format(R"("sparse":{{"count":{},"indices":{{"bufferView":{},"componentType":5121}},)"
                              R"("values":{{"bufferView":{}}}}})",
                              count, indices, values));
    gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0}}]})";
    return gltf;
  };
  EXPECT_EQ(refusal(sparse({1, 2}, "2")), "loaded without complaint");
  expect(refusal(sparse({1, 3}, "2")),
         "/accessors/0/sparse/indices: expected indices that ascend and are below 3, found 3");
  expect(refusal(sparse({2, 1}, "2")), "found 1");
  expect(refusal(sparse({1, 2}, "3")), "do not fit");
  expect(refusal(sparse({1, 2}, "4000000000")), "do not fit");
}

TEST_F(LoadGltfDamaged, nodes_must_be_trees) {
  auto gltf = one_triangle();
  gltf.rest = R"(,"scenes":[{"nodes":[0]}])";
  gltf.nodes = R"({"mesh":0,"children":[1]},{"children":[0]})";
  expect(refusal(gltf), "/nodes/1/children/0: expected a tree of nodes");
  gltf.nodes = R"({"mesh":0,"children":[0]})";
  expect(refusal(gltf), "node 0 is below itself or two others");
  gltf.nodes = R"({"mesh":0,"children":[1,1]},{"mesh":0})";
  expect(refusal(gltf), "node 1 is below itself or two others");
  gltf.rest = "";
  gltf.nodes = R"({"mesh":0,"children":[1]},{"children":[0]})";
  expect(refusal(gltf), "/nodes: expected trees of nodes");
}

TEST_F(LoadGltfDamaged, numbers_must_be_numbers) {
  const auto nan = std::numeric_limits<float>::quiet_NaN();
  SmallGltf gltf;
  gltf.points({0, 0, 0, 1, 0, 0, 0, nan, 0});
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0}}]})";
  expect(refusal(gltf), "/accessors/0: vertex 2 is not finite");
  gltf = one_triangle();
  gltf.nodes = R"({"mesh":0,"scale":[1e200,1,1]})";
  expect(refusal(gltf), "/accessors/0: vertex 1 is not finite, or comes to lie beyond 1e+12 m");
  gltf.nodes = R"({"mesh":0,"scale":[1,1]})";
  expect(refusal(gltf), "/nodes/0/scale: expected 3 numbers, found 2");
  gltf.nodes = R"({"mesh":0,"rotation":[0,0,0,0]})";
  expect(refusal(gltf), "/nodes/0/rotation: expected a quaternion");
  gltf.nodes = R"({"mesh":0,"translation":"far"})";
  expect(refusal(gltf), "/nodes/0/translation: expected an array, found \"far\"");
  gltf.nodes = R"({"mesh":0})";
  for (
      const auto& [material, words] : std::vector<std::pair<std::string, std::string>>{
          {R"({"emissiveFactor":[-1,0,0]})", "/materials/0/emissiveFactor: expected colours of 0 to"},
          {R"({"pbrMetallicRoughness":{"baseColorFactor":[1,1,1]}})",
           "/materials/0/pbrMetallicRoughness/baseColorFactor: expected 4 numbers"},
          {R"({"emissiveFactor":[1,1,1],"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":-2}}})",
           "emissiveStrength: expected a strength"},
          {R"({"alphaMode":"CLIP"})", "/materials/0/alphaMode: expected OPAQUE, MASK or BLEND"},
          {R"({"emissiveTexture":{"index":0}})",
           "/materials/0/emissiveTexture/index: it names number 0 of the textures"}}) {
    gltf.meshes = R"({"primitives":[{"material":0,"attributes":{"POSITION":0}}]})";
    gltf.rest = fmt::format(R"(,"materials":[{}])", material);
    expect(refusal(gltf), words);
  }
}

TEST_F(LoadGltfDamaged, lamps_and_cameras_must_make_sense) {
  auto gltf = one_triangle();
  const auto lamp = [&](const std::string& light) {
    gltf.nodes = R"({"mesh":0},{"extensions":{"KHR_lights_punctual":{"light":0}}})";
    gltf.rest = fmt::format(R"(,"extensions":{{"KHR_lights_punctual":{{"lights":[{}]}}}})", light);
    return refusal(gltf);
  };
  expect(lamp(""), "/nodes/1/extensions/KHR_lights_punctual/light: it names lamp 0");
  expect(lamp(R"({"type":"area"})"), "lights/0/type: expected point, spot or directional");
  expect(lamp(R"({"type":"point","intensity":-1})"), "expected colour times intensity");
  expect(lamp(R"({"type":"spot","spot":{"innerConeAngle":1,"outerConeAngle":0.5}})"),
         "expected 0 <= innerConeAngle");
  gltf.nodes = R"({"mesh":0},{"camera":0,"scale":[0,0,0]})";
  gltf.rest = R"(,"cameras":[{"perspective":{"yfov":1}}])";
  expect(refusal(gltf), "/nodes/1: expected an axis");
  gltf.rest = R"(,"cameras":[{"perspective":{"yfov":9}}])";
  gltf.nodes = R"({"mesh":0},{"camera":0})";
  expect(refusal(gltf), "/cameras/0/perspective/yfov: expected an angle");
}

TEST_F(LoadGltfDamaged, other_files_are_looked_for_beside_this_one_alone) {
  const auto gltf = one_triangle();
  const auto with = [&](const std::string& uri) {
    return refusal(gltf.json(fmt::format(R"(,"uri":"{}")", uri)));
  };
  expect(with("gone.bin"), "/buffers/0/uri: there is no file 'gone.bin'");
  expect(with("/etc/passwd"), "the file '/etc/passwd' lies outside the scene's folder");
  expect(with("file:///etc/passwd"), "expected the name of a file");
  expect(with("https://example.org/a.bin"), "expected the name of a file");
  expect(with("a%00b"), "expected the name of a file");
  expect(with("data:application/octet-stream;base64,AA*A"), "found a damaged data URI");
  expect(with("data:text/plain,abc"), "found a damaged data URI");
  expect(with("data:;base64,AAAA"), "it says that it has 36 bytes, and 3 are there");
}

// Numerical Recipes' linear congruential generator: the same damage on every host.
class Dice {
 public:
  std::size_t below(std::size_t n) { return ((state_ = state_ * 1664525u + 1013904223u) >> 8) % n; }

 private:
  std::uint32_t state_ = 2026;
};

TEST_F(LoadGltfDamaged, every_damage_is_answered) {
  auto good = indexed();
  good.array<float>(SmallGltf::f32, "VEC2", 3, {0, 0, 1, 0, 0, 1});
  good.meshes =
      R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":2,"COLOR_0":0},"indices":1,"material":0}]})";
  good.nodes =
      R"({"children":[1,2]},{"mesh":0,"scale":[1,2,3]},{"camera":0,"extensions":{"KHR_lights_punctual":{"light":0}}})";
  good.rest =
      R"(,"materials":[{"alphaMode":"MASK","emissiveFactor":[1,1,1]}],"cameras":[{"perspective":{"yfov":1}}],)"
      R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot"}]}},"scenes":[{"nodes":[0]}])";
  const auto bytes = good.glb();
  const std::string tongue = "0123456789.-+eE[]{}\",:null \xFF";
  Dice dice;
  std::size_t sound = 0;
  for (int round = 0; round < 2000; ++round) {
    auto damaged = bytes;
    for (auto times = 1 + dice.below(3); times > 0; --times)
      damaged[dice.below(damaged.size())] = tongue[dice.below(tongue.size())];
    files_.write("room.glb", damaged);
    try {
      check_scene(files_.load("room.glb"));
      ++sound;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("room."), std::string::npos) << error.what();
    }
  }
  EXPECT_GT(sound, 0u);
}

}  // namespace
}  // namespace luxel
