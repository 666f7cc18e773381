// SPDX-License-Identifier: Apache-2.0
// End-to-end tests of lightmaps.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "luxel/core/output_file.h"
#include "luxel/image/image_file.h"

#include "cli/run_program.h"
#include "support/small_gltf.h"

namespace luxel::cli {
namespace {

using Json = nlohmann::json;
const std::string bake_for_maps =
    "$LUXEL bake cornell-box.obj --max-edge 0.15 --error 20% --quiet -o box.vtkhdf > bake.txt && ";
const std::string lightmap = "$LUXEL lightmap box.vtkhdf --texels-per-metre 20 ";

TEST(LightmapCommand, writes_pages_an_error_map_and_a_preview) {
  const auto folder = fresh_folder("lightmap");
  const auto run =
      cli::run(folder, bake_for_maps + lightmap +
                           "-o map.exr -o map.png --png-white 50 --final-gather 20% "
                           "--error-map error.exr --preview view.png --width 40 --height 30 --json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("charts on 1 page of 48 x 48 texels"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("gathered with"), std::string::npos) << run.err;
  const auto json = Json::parse(run.out);
  EXPECT_EQ(json["command"], "lightmap");
  EXPECT_EQ(json["outputs"], Json({"map.exr", "map.png", "error.exr", "view.png"}));
  const auto page = read_image(folder / "map.exr"), codes = read_image(folder / "map.png"),
             error = read_image(folder / "error.exr");
  ASSERT_EQ(page.width, 48);
  ASSERT_EQ(error.pixels.size(), page.pixels.size());
  // The metadata of the file: white is 50 W/m².
  EXPECT_NE(read_file(folder / "map.png")
                .find(std::string("tEXtWhite W/m2\0"
                                  "50",
                                  17)),
            std::string::npos);
  for (std::size_t i = 0; i < page.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const auto shown = 50.0f * codes.pixels[i][c], there = std::min(50.0f, page.pixels[i][c]);
      EXPECT_NEAR(shown, there, 0.01f * there + 0.02f);
    }
  EXPECT_GT(mean_color(error).g, 0.0f);
  EXPECT_LT(mean_color(error).g, 0.5f * mean_color(page).g);
  EXPECT_GT(mean_color(read_image(folder / "view.png")).g, 0.05f);
}

TEST(LightmapCommand, gives_the_same_bytes_on_any_number_of_threads_and_numbers_its_pages) {
  const auto folder = fresh_folder("lightmap_repeats");
  const auto run = cli::run(folder, bake_for_maps + lightmap +
                                        "-o a.exr --page-size 32 --final-gather none --threads 1 && " +
                                        lightmap + "-o b.exr --page-size 32 --final-gather none --threads 5");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out.substr(0, 21), "a.exr\na-2.exr\na-3.exr");
  EXPECT_EQ(read_file(folder / "a.exr"), read_file(folder / "b.exr"));
  EXPECT_EQ(read_file(folder / "a-2.exr"), read_file(folder / "b-2.exr"));
}

// A file of `export --as lightmap` defines the layout of its surfaces.
TEST(LightmapCommand, lays_surfaces_out_as_the_scenes_file_has_them) {
  const auto folder = fresh_folder("lightmap_scene");
  const std::string pages = "--texels-per-metre 40 --final-gather none ";
  const auto made = cli::run(
      folder, bake_for_maps + "$LUXEL export box.vtkhdf --scene cornell-box.obj --as lightmap " + pages +
                  "-o laid.glb --quiet && "
                  "$LUXEL bake laid.glb --sky 1 --max-edge 0.15 --error 20% -o laid.vtkhdf --quiet");
  ASSERT_EQ(made.code, 0) << made.err;
  const auto pages_of = [&](const std::string& line) {
    const auto run = cli::run(folder, "$LUXEL " + line + pages + "--json --quiet");
    EXPECT_EQ(run.code, 0) << run.err;
    return Json::parse(run.out)["pages"];
  };
  const auto own = pages_of("lightmap laid.vtkhdf --scene laid.glb -o own.exr ");
  EXPECT_EQ(own["layout"], "file");
  EXPECT_EQ(own["pages"], 1);
  EXPECT_EQ(own["charts"], 1);
  EXPECT_EQ(own, pages_of("export laid.vtkhdf --scene laid.glb --as lightmap -o again.glb "));
  const auto anew = pages_of("lightmap laid.vtkhdf --scene laid.glb --layout new -o new.exr ");
  EXPECT_EQ(anew["layout"], "new");
  EXPECT_GT(anew["charts"], 5);
  EXPECT_EQ(anew, pages_of("lightmap laid.vtkhdf -o new.exr "));
  EXPECT_EQ(read_image(folder / "own.exr").width, own["page_size"]);

  const auto other = cli::run(folder, "$LUXEL lightmap laid.vtkhdf --scene cornell-box.obj -o no.exr");
  EXPECT_EQ(other.code, 1);
  EXPECT_NE(other.err.find("cornell-box.obj: it is not what laid.vtkhdf was solved from"), std::string::npos)
      << other.err;
}

// One large sheet and 300 small ones with a page each in the file; all pages have the size that the large one
// needs.
TEST(LightmapCommand, a_files_layout_of_pages_that_are_all_but_empty_is_not_taken) {
  const auto folder = fresh_folder("lightmap_empty_pages");
  SmallGltf gltf;
  gltf.points({0, 0, 0, 2, 0, 0, 0, 2, 0});
  gltf.array<float>(SmallGltf::f32, "VEC2", 3, {0, 0, 1, 0, 0, 1});
  gltf.meshes = R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_1":1}}]})";
  gltf.nodes = R"({"mesh":0,"scale":[80,80,1],"translation":[0,0,-1]})";
  std::string all = "0";
  for (int i = 1; i <= 300; ++i) {
    gltf.nodes += fmt::format(R"(,{{"mesh":0,"translation":[{},0,0]}})", 3 * i);
    all += fmt::format(",{}", i);
  }
  gltf.rest = fmt::format(R"(,"scene":0,"scenes":[{{"nodes":[{}]}}])", all);
  write_file(folder / "sheets.glb", gltf.glb());
  const auto run = cli::run(folder,
                            "$LUXEL bake sheets.glb --sky 1 --error 20% --as lightmap --final-gather none "
                            "--texels-per-metre 1 -o out.glb --json");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("their 301 pages of 256 x 256 texels would be 20 million"), std::string::npos)
      << run.err;
  EXPECT_EQ(Json::parse(run.out)["pages"]["layout"], "new");
}

TEST(LightmapCommand, says_in_its_report_what_was_made) {
  const auto folder = fresh_folder("lightmap_report");
  const auto run = cli::run(
      folder, bake_for_maps + lightmap + "-o map.exr --final-gather 1% --gather-rays 64 --quiet --json");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto pages = Json::parse(run.out)["pages"];
  EXPECT_EQ(pages["page_size"], read_image(folder / "map.exr").width);
  EXPECT_EQ(pages["error_target"], 0.01);
  EXPECT_EQ(pages["stopped"], false);
  EXPECT_GE(pages["texels"], pages["gathered"]);
  EXPECT_GT(pages["short_of_error"], 0);  // by so few rays
  EXPECT_GE(pages["gathered"], pages["short_of_error"]);
  EXPECT_GE(pages["rays"], 64 * pages["gathered"].get<int>());
  EXPECT_GE(pages["seams"]["difference_before"], pages["seams"]["difference_after"]);
}

TEST(LightmapCommand, and_export_say_that_they_were_stopped_while_texels_were_gathered) {
  const auto folder = fresh_folder("lightmap_stopped");
  const std::string gather =
      " --texels-per-metre 200 --final-gather 0.01% --gather-rays 65536 --progress json";
  ASSERT_EQ(cli::run(folder, bake_for_maps + "true").code, 0);
  for (const std::string file : {"map.exr", "map.glb"}) {
    const auto line = (file == "map.exr" ? "$LUXEL lightmap box.vtkhdf -o "
                                         : "$LUXEL export box.vtkhdf --as lightmap -o ") +
                      file + gather;
    const auto run = run_interrupted(folder, line, "grep -q texels stderr.txt");
    EXPECT_EQ(run.code, 3) << line << run.err;
    const bool is_written = std::filesystem::exists(folder / file);
    // A busy machine may not have written it within its second.
    const auto* said = is_written ? "stopped: texels that were not gathered" : "stopped: no further file";
    EXPECT_NE(run.err.find(said), std::string::npos) << run.err;
  }
}

// Existing pages remain unchanged.
TEST(LightmapCommand, and_export_write_nothing_when_stopped_after_the_texels) {
  const auto folder = fresh_folder("lightmap_stopped_late");
  ASSERT_EQ(cli::run(folder, bake_for_maps + "true").code, 0);
  write_file(folder / "map.exr", "old");
  for (const std::string line : {"$LUXEL lightmap box.vtkhdf -o map.png -o map.exr",
                                 "$LUXEL export box.vtkhdf --as emissive -o map.glb"}) {
    const auto run =
        run_interrupted(folder, line + " --texels-per-metre 1200 --final-gather none --progress json",
                        "grep -q 'places\\|seams' stderr.txt");
    EXPECT_EQ(run.code, 3) << line << run.err;
    EXPECT_NE(run.err.find("stopped"), std::string::npos) << run.err;
  }
  EXPECT_EQ(read_file(folder / "map.exr"), "old");
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    EXPECT_TRUE(entry.path().filename().string().find("map") == std::string::npos ||
                entry.path().filename() == "map.exr")
        << entry.path();
}

TEST(LightmapCommand, refuses_what_makes_no_sense_in_a_sentence) {
  const auto folder = fresh_folder("lightmap_refuses");
  ASSERT_EQ(cli::run(folder, bake_for_maps + "true").code, 0);
  struct Misuse {
    std::string options, word;
    int code;
  };
  for (const auto& misuse :
       {Misuse{"", "at least one -o", 2}, Misuse{"-o map.glb", "expected one of the extensions .exr .png", 2},
        Misuse{"-o map.exr --final-gather 2", "such as 2%", 2},
        Misuse{"-o map.exr --error-map error.png", "the extension .exr", 2},
        Misuse{"-o map.exr --error-map map.exr", "given twice", 2},
        Misuse{"-o map.exr --uv2 nowhere/a.glb", "--uv2: cannot write nowhere/a.glb", 1},
        Misuse{"-o map.exr --texels-per-metre 1e6", "fewer texels per metre", 1},
        Misuse{"-o map.exr --page-size 8 --margin 4", "margin", 1}}) {
    const auto run = cli::run(folder, "$LUXEL lightmap box.vtkhdf " + misuse.options);
    EXPECT_EQ(run.code, misuse.code) << misuse.options;
    EXPECT_NE(run.err.find(misuse.word), std::string::npos) << misuse.options << '\n' << run.err;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "map.exr"));
}

// A solve of half an hour.
TEST(LightmapCommand, of_a_bake_refuses_too_many_texels_before_the_light) {
  const auto folder = fresh_folder("lightmap_too_many");
  const auto run = cli::run(folder,
                            "timeout 60 $LUXEL bake cornell-box.obj --as lightmap --texels-per-metre 1e6 "
                            "--mesh-error none --error 0.001% -o a.glb");
  EXPECT_EQ(run.code, 1) << run.err;
  EXPECT_NE(run.err.find("fewer texels per metre (--texels-per-metre)"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace luxel::cli
