// SPDX-License-Identifier: Apache-2.0
#include "luxel/import/make_materials.h"

#include "fuzz/answered.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return luxel::answered(data, size, [](std::string_view text) {
    luxel::MaterialLibrary library;
    std::vector<luxel::NamedLine> used;
    for (auto& material : luxel::read_mtl(text, "nowhere/room.mtl")) {
      used.push_back({material.name, 1});
      auto name = material.name;
      library.entries.try_emplace(std::move(name),
                                  luxel::MaterialLibrary::Entry{std::move(material), "nowhere"});
    }
    luxel::Scene scene;
    scene.source = "nowhere/room.obj";
    luxel::make_materials(used, library, {}, scene, {});
    // One triangle for each, so that there is a scene to look at.
    scene.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    scene.groups = {"default"};
    scene.triangles.assign(used.size(), {0, 1, 2});
    scene.triangle_line.assign(used.size(), 1);
    scene.triangle_group.assign(used.size(), 0);
    for (std::size_t i = 0; i < used.size(); ++i)
      scene.triangle_material.push_back(luxel::MaterialId{static_cast<std::uint32_t>(i)});
    if (!used.empty()) luxel::expect_sound(scene);
  });
}
