// SPDX-License-Identifier: Apache-2.0
// Exported files in their compressed forms: Luxel reads back the contents of the plain file.
#include <string>

#include <gtest/gtest.h>

#include "luxel/core/error.h"
#include "luxel/core/output_file.h"
#include "luxel/export/export_mesh.h"
#include "luxel/export/export_round_trip.h"
#include "luxel/import/load_gltf.h"
#include "luxel/render/lightmap.h"
#include "luxel/surface/make_charts.h"

#include "support/lightmap_places.h"
#include "support/round_trip_file.h"
#include "support/same_triangles.h"

namespace luxel {
namespace {

using namespace test;

constexpr double half_step = 0.5 * 0x1p-12;  // of a mesh of 4 to 8 m in 15 bits

// small_room() without the extension that is unknown to Luxel, which prevents packing.
SmallGltf known_room() {
  auto gltf = small_room();
  const std::string unknown = R"(,"FREE_wind"])";
  gltf.rest.replace(gltf.rest.find(unknown), unknown.size(), "]");
  return gltf;
}

class ExportCompressed : public ExportRoundTrip {
 protected:
  void SetUp() override {
    files_.write("room.glb", known_room().glb());
    solve("room.glb", 0.4f);
  }

  // write(options): the same light on the same scene, to out().
  template <typename Write>
  void expect_same(const Write& write) {
    RoundTripOptions options;
    write(options);
    const auto plain = files_.load("lit.glb");
    const auto warnings = files_.all_warnings();
    const auto plain_size = read_file(out()).size();
    for (const auto compression : {MeshCompression::quantised, MeshCompression::meshopt}) {
      if (!is_available(compression)) continue;
      options.compression = compression;
      write(options);
      EXPECT_LE(read_file(out()).size(), plain_size) << name(compression);
      const auto scene = files_.load("lit.glb");
      EXPECT_EQ(files_.all_warnings(), warnings);
      EXPECT_EQ(scene.textures.size(), plain.textures.size());
      expect_same_triangles(plain, scene, half_step);
    }
  }
};

TEST_F(ExportCompressed, light_at_vertices) {
  const auto light = make_smooth_light(patches_, solution_);
  expect_same(
      [&](const RoundTripOptions& options) { export_round_trip_cut(out(), input(), light, options); });
}

TEST_F(ExportCompressed, light_at_the_vertices_of_the_file) {
  const auto fit = fit_vertices(scene_, patches_, make_smooth_light(patches_, solution_));
  expect_same(
      [&](const RoundTripOptions& options) { export_round_trip_uncut(out(), input(), fit, options); });
}

TEST_F(ExportCompressed, light_on_pages) {
  const auto atlas = new_atlas(patches_, solution_, {.texel = 0.05f, .page_size = 64});
  const auto pages = pages_of_places(patches_, atlas);
  expect_same([&](const RoundTripOptions& options) {
    export_round_trip_lightmap(out(), input(), {atlas, pages, 1.0f}, options);
  });
  expect_same([&](const RoundTripOptions& options) {
    export_round_trip_emissive(out(), input(), {atlas, pages}, options);
  });
  expect_same([&](const RoundTripOptions& options) {
    export_unwrapped(out(), input(), {atlas, pages, 1.0f}, options);
  });
}

// The solution of the file that was read back has the same patches, within half a step.
TEST_F(ExportCompressed, a_file_that_is_written_can_be_written_again) {
  const auto atlas = new_atlas(patches_, solution_, {.texel = 0.05f, .page_size = 64});
  const auto pages = pages_of_places(patches_, atlas);
  RoundTripOptions options;
  options.compression = MeshCompression::quantised;
  export_round_trip_lightmap(out(), input(), {atlas, pages, 1.0f}, options);
  files_.write("again.glb", read_file(out()));
  const auto first = patches_.size();
  solve("again.glb", 0.4f);
  EXPECT_NEAR(static_cast<double>(patches_.size()), static_cast<double>(first),
              0.1 * static_cast<double>(first));
  const auto light = make_smooth_light(patches_, solution_);
  export_round_trip_cut(out(), input(), light, {});
  expect_same([&](const RoundTripOptions& again) { export_round_trip_cut(out(), input(), light, again); });
}

TEST_F(ExportCompressed, the_lit_mesh_alone) {
  const auto light = make_smooth_light(patches_, solution_);
  ExportOptions options;
  export_glb(out(), patches_, solution_, light, Vec3(0.0f, 0.0f, 1.0f), options);
  const auto plain = files_.load("lit.glb");
  for (const auto compression : {MeshCompression::quantised, MeshCompression::meshopt}) {
    if (!is_available(compression)) continue;
    options.compression = compression;
    export_glb(out(), patches_, solution_, light, Vec3(0.0f, 0.0f, 1.0f), options);
    expect_same_triangles(plain, files_.load("lit.glb"), 2.0 * half_step);
  }
}

// Godot and Unreal read no quantised positions, and these, like Blender, no compressed arrays.
TEST_F(ExportCompressed, each_program_gets_what_it_reads) {
  const auto light = make_smooth_light(patches_, solution_);
  for (const auto word : mesh_program_names()) {
    const auto program = *target_application(word);
    export_glb(out(), patches_, solution_, light, Vec3(0.0f, 1.0f, 0.0f),
               {.tone = {}, .program = program, .compression = MeshCompression::quantised});
    const auto is_required = read_file(out()).find("KHR_mesh_quantization") != std::string::npos;
    EXPECT_EQ(is_required, program != TargetApplication::godot && program != TargetApplication::unreal)
        << word;
    if (!is_available(MeshCompression::meshopt)) continue;
    export_glb(out(), patches_, solution_, light, Vec3(0.0f, 1.0f, 0.0f),
               {.tone = {}, .program = program, .compression = MeshCompression::meshopt});
    const auto is_compressed = read_file(out()).find("EXT_meshopt_compression") != std::string::npos;
    EXPECT_EQ(is_compressed, profile_of(program).reads_meshopt) << word;
  }
}

TEST_F(ExportCompressed, the_same_light_gives_the_same_bytes) {
  const auto light = make_smooth_light(patches_, solution_);
  for (const auto compression : {MeshCompression::quantised, MeshCompression::meshopt}) {
    if (!is_available(compression)) continue;
    RoundTripOptions options;
    options.compression = compression;
    export_round_trip_cut(out(), input(), light, options);
    const auto bytes = read_file(out());
    export_round_trip_cut(out(), input(), light, options);
    EXPECT_EQ(read_file(out()), bytes);
  }
}

}  // namespace
}  // namespace luxel
