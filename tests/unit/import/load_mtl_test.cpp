// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "luxel/image/image_file.h"
#include "luxel/import/read_mtl.h"

#include "support/scene_files.h"

namespace luxel {
namespace {

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";

// The only material of a triangle that uses m of an MTL file.
Material load_material(SceneFiles& files, const std::string& mtl, const LoadOptions& options = {}) {
  files.write("room.mtl", mtl);
  const auto scene = files.load_text("mtllib room.mtl\n" + triangle + "usemtl m\nf 1/1 2/2 3/3\n", options);
  check_scene(scene);
  return scene.materials.at(0);
}

std::string refusal(SceneFiles& files, const std::string& mtl) {
  files.write("room.mtl", mtl);
  return files.refusal_of_text("mtllib room.mtl\n" + triangle + "usemtl m\nf 1/1 2/2 3/3\n");
}

// A texture half black, half white, whose mean is exactly a half.
void write_half_white(const std::filesystem::path& path) {
  Image image(2, 1);
  image.at(1, 0) = Vec3(1.0f);
  write_png(path, image);
}

TEST(LoadMtl, Kd_is_the_reflectance_and_pi_Ke_the_emittance) {
  SceneFiles files;
  const auto material = load_material(files, "newmtl m\nKd 0.1 0.2 0.3\nKe 17 12 4\n");
  EXPECT_EQ(material.reflectance, Vec3(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(material.emittance, pi * Vec3(17, 12, 4));
  EXPECT_TRUE(material.two_sided);
  EXPECT_TRUE(files.warnings().empty()) << files.all_warnings();
}

TEST(LoadMtl, one_number_is_a_grey_and_a_comment_may_follow) {
  SceneFiles files;
  EXPECT_EQ(load_material(files, "newmtl m\nKd 0.25 # concrete\n").reflectance, Vec3(0.25f));
  EXPECT_EQ(load_material(files, "newmtl m\nKd 0.1 0.2 0.3 # red\n").reflectance, Vec3(0.1f, 0.2f, 0.3f));
}

TEST(LoadMtl, colours_that_are_no_numbers_name_file_and_line) {
  SceneFiles files;
  EXPECT_EQ(refusal(files, "newmtl m\n\nKd 0.1 0.2\n"),
            "room.mtl:3: expected three finite numbers after Kd, found '0.1 0.2'");
  EXPECT_EQ(refusal(files, "newmtl m\nKd 1 nan 1\n"),
            "room.mtl:2: expected three finite numbers after Kd, found '1 nan 1'");
  EXPECT_EQ(refusal(files, "newmtl m\nKe red\n"),
            "room.mtl:2: expected three finite numbers after Ke, found 'red'");
  EXPECT_EQ(refusal(files, "newmtl m\nKd\n"), "room.mtl:2: expected three finite numbers after Kd, found ''");
  EXPECT_EQ(refusal(files, "newmtl m\nd x\n"), "room.mtl:2: expected a finite number after d, found 'x'");
  EXPECT_EQ(refusal(files, "newmtl m\nKe 3e38 0 0\n"),
            "room.mtl:2: expected numbers below 1e38 after Ke, found '3e38 0 0'");
}

TEST(LoadMtl, negative_colours_name_file_and_line) {
  SceneFiles files;
  EXPECT_EQ(refusal(files, "newmtl m\nKd 0 -0.5 0\n"),
            "room.mtl:2: expected numbers of 0 or more after Kd, found '0 -0.5 0'");
  EXPECT_EQ(refusal(files, "newmtl m\nKe -1 0 0\n"),
            "room.mtl:2: expected numbers of 0 or more after Ke, found '-1 0 0'");
}

TEST(LoadMtl, a_reflectance_too_high_is_lowered_and_told_once) {
  SceneFiles files;
  files.write("room.mtl", "newmtl a\nKd 1 1 0.5\nnewmtl b\nKd 3 0 0\nnewmtl c\nKd 0.9 0.9 0.9\n");
  const auto scene =
      files.load_text("mtllib room.mtl\n" + triangle +
                          "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 2/2 3/3\nusemtl c\nf 1/1 2/2 3/3\n",
                      {.max_reflectance = 0.95f});
  EXPECT_EQ(scene.materials[0].reflectance, Vec3(0.95f, 0.95f, 0.5f));
  EXPECT_EQ(scene.materials[1].reflectance, Vec3(0.95f, 0, 0));
  EXPECT_EQ(scene.materials[2].reflectance, Vec3(0.9f));
  EXPECT_EQ(files.all_warnings(),
            "room.obj: the reflectance of 'a', 'b' was lowered to 0.95, as no surface reflects all light\n");
}

TEST(LoadMtl, without_Kd_and_map_Kd_a_grey_is_taken_and_told) {
  SceneFiles files;
  EXPECT_EQ(load_material(files, "newmtl m\nNs 10\n").reflectance, Vec3(0.5f));
  EXPECT_EQ(files.all_warnings(),
            "room.obj: neither Kd nor map_Kd is given for 'm'; a grey of 0.5 is taken\n");
}

TEST(LoadMtl, what_lets_most_light_through_is_left_out_and_told) {
  SceneFiles files;
  for (const std::string glass : {"d 0.1", "d -halo 0.2", "d 0.4\nTr 0.0"}) {
    EXPECT_FALSE(load_material(files, "newmtl m\nKd 0.2 0.2 0.2\n" + glass + "\n").opaque);
    EXPECT_EQ(files.all_warnings(),
              "room.obj: light passes freely through what is more transparent than not (d below 0.5), which "
              "is left "
              "out: 'm'\n")
        << glass;
  }
  for (const std::string solid : {"d 1", "Tr 0.9", "d 0.6", "d 0.1\nKe 1 1 1"}) {
    EXPECT_TRUE(load_material(files, "newmtl m\nKd 0.2 0.2 0.2\n" + solid + "\n").opaque) << solid;
    EXPECT_EQ(files.all_warnings(), "");
  }
}

TEST(LoadMtl, Tf_of_glass_is_its_transmittance) {
  SceneFiles files;
  const std::string glass = "newmtl m\nKd 0 0 0\nillum 7\nNi 1.5\n";
  const auto pane = load_material(files, glass + "Tf 0.8 0.85 0.75\n");
  EXPECT_FALSE(pane.opaque);
  EXPECT_EQ(pane.transmittance, Vec3(0.8f, 0.85f, 0.75f));
  EXPECT_EQ(files.all_warnings(), "room.obj: panes of glass, with the transmittance Tf of the file: 'm'\n");
  EXPECT_EQ(load_material(files, "newmtl m\nd 0.3\nTf 0.7\n").transmittance, Vec3(0.7f));
  EXPECT_EQ(load_material(files, "newmtl m\nd 0.6\nTf 0.7\n").transmittance, Vec3(1.0f));  // opaque
  files.all_warnings();
}

TEST(LoadMtl, Tf_that_is_no_transmittance_is_passed_over) {
  SceneFiles files;
  const std::string glass = "newmtl m\nKd 0 0 0\nillum 7\nNi 1.5\n";
  for (const auto& text : {glass, glass + "Tf 1 1 1\n", glass + "Tf 2 2 2\n",
                           std::string("newmtl m\nd 0.2\nTf 0.2 0.2 0.2\n"),  // the opacity again
                           std::string("newmtl m\nd 0.2\nTf 0 0 0\n")}) {
    const auto material = load_material(files, text);
    EXPECT_FALSE(material.opaque) << text;
    EXPECT_EQ(material.transmittance, Vec3(1.0f)) << text;
    EXPECT_NE(files.all_warnings().find("light passes freely"), std::string::npos) << text;
  }
}

TEST(LoadMtl, a_mirror_lends_its_specular_colour_and_is_reported) {
  SceneFiles files;
  EXPECT_EQ(load_material(files, "newmtl m\nKd 0 0 0\nKs 0.7 0.6 0.5\n").reflectance, Vec3(0.7f, 0.6f, 0.5f));
  EXPECT_EQ(files.all_warnings(),
            "room.obj: stand-ins, since mirrors and glass are not modelled: the specular colour Ks, at most "
            "0.8, is "
            "taken as diffuse for 'm'\n");
  EXPECT_EQ(load_material(files, "newmtl m\nKd 0 0 0\nKs 1 0.9 0.3\n").reflectance, Vec3(0.8f, 0.8f, 0.3f));
  EXPECT_EQ(load_material(files, "newmtl m\nKd 0.1 0 0\nKs 1 1 1\n").reflectance, Vec3(0.1f, 0.0f, 0.0f));
  EXPECT_EQ(load_material(files, "newmtl m\nKd 0 0 0\nKs 1 1 1\nKe 5 5 5\n").reflectance, Vec3(0.0f));
  EXPECT_EQ(files.all_warnings(), "");
}

TEST(LoadMtl, dark_metal_that_illum_lets_reflect_shows_its_specular_colour) {
  SceneFiles files;
  for (const std::string illum : {"3", "5", "7"}) {
    const auto chrome = "newmtl m\nKd 0.125 0.125 0.125\nKs 0.5 0.5 0.25\nillum " + illum + "\n";
    EXPECT_EQ(load_material(files, chrome).reflectance, Vec3(0.625f, 0.625f, 0.375f)) << illum;
    EXPECT_NE(files.all_warnings().find("'m'"), std::string::npos);
  }
  const std::string dark = "newmtl m\nKd 0.125 0.125 0.125\n", light = "newmtl m\nKd 0.5 0.5 0.5\n";
  for (const auto& other : {dark + "illum 2\nKs 1 1 1", dark + "illum 3\nKs 0.04 0.04 0.04"}) {
    EXPECT_EQ(load_material(files, other + "\n").reflectance, Vec3(0.125f)) << other;
    EXPECT_EQ(files.all_warnings(), "") << other;
  }
  EXPECT_EQ(load_material(files, light + "illum 3\nKs 1 1 1\n").reflectance, Vec3(0.5f));
}

TEST(LoadMtl, light_passes_through_glass_whatever_its_opacity) {
  SceneFiles files;
  EXPECT_FALSE(load_material(files, "newmtl m\nKd 0 0 0\nKs 1 1 1\nillum 7\nNi 1.5\n").opaque);
  EXPECT_EQ(
      files.all_warnings(),
      "room.obj: stand-ins, since mirrors and glass are not modelled: light passes freely through 'm', which "
      "is left out\n");
  // Opaque: of writers that give everything illum 4, what passes no light, and what has a colour or shines.
  for (const std::string solid :
       {"Kd 0.1 0.1 0.1\nillum 4\nTf 1 1 1\nNi 1", "Kd 0.1 0.1 0.1\nillum 7\nNi 1.5\nTf 0 0 0",
        "Kd 0.6 0.5 0.5\nillum 7\nNi 1.5", "Kd 0 0 0\nillum 7\nNi 1.5\nKe 1 1 1"})
    EXPECT_TRUE(load_material(files, "newmtl m\n" + solid + "\n").opaque) << solid;
}

TEST(LoadMtl, the_mean_of_a_texture_multiplies_Kd) {
  SceneFiles files;
  write_half_white(files.path("half.png"));
  EXPECT_EQ(load_material(files, "newmtl m\nKd 0.5 1 0.2\nmap_Kd half.png\n").reflectance,
            Vec3(0.25f, 0.5f, 0.1f));
  EXPECT_EQ(load_material(files, "newmtl m\nmap_Kd half.png\n").reflectance, Vec3(0.5f));
  EXPECT_TRUE(files.warnings().empty()) << files.all_warnings();
}

TEST(LoadMtl, texture_names_start_at_the_folder_of_the_mtl) {
  SceneFiles files;
  files.write("sub/room.mtl", "newmtl m\nmap_Kd textures\\half.png\n");
  std::filesystem::create_directories(files.path("sub/textures"));
  write_half_white(files.path("sub/textures/half.png"));
  const auto scene = files.load_text("mtllib sub\\room.mtl\n" + triangle + "usemtl m\nf 1/1 2/2 3/3\n");
  EXPECT_EQ(scene.materials[0].reflectance, Vec3(0.5f));
  EXPECT_TRUE(files.warnings().empty()) << files.all_warnings();
}

TEST(LoadMtl, the_path_of_another_machine_is_looked_for_beside_the_file) {
  SceneFiles files;
  write_half_white(files.path("half.png"));
  EXPECT_EQ(load_material(files, "newmtl m\nmap_Kd C:\\art\\half.png\n").reflectance, Vec3(0.5f));
  EXPECT_TRUE(files.warnings().empty()) << files.all_warnings();
}

TEST(LoadMtl, missing_textures_are_told_in_one_sentence) {
  SceneFiles files;
  files.write(
      "room.mtl",
      "newmtl a\nmap_Kd x.png\nnewmtl b\nKd 0.4 0.4 0.4\nmap_Kd my wood.png\nnewmtl c\nmap_Kd x.png\n");
  const auto scene =
      files.load_text("mtllib room.mtl\n" + triangle +
                      "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 2/2 3/3\nusemtl c\nf 1/1 2/2 3/3\n");
  EXPECT_EQ(scene.materials[0].reflectance, Vec3(0.5f));
  EXPECT_EQ(scene.materials[1].reflectance, Vec3(0.2f));
  EXPECT_EQ(
      files.all_warnings(),
      "room.obj: 2 textures not found (first: x.png, needed by material 'a'); 0.5 is taken for the mean\n");
}

TEST(LoadMtl, a_damaged_texture_is_told) {
  SceneFiles files;
  files.write("bad.png", "no picture");
  EXPECT_EQ(load_material(files, "newmtl m\nmap_Kd bad.png\n").reflectance, Vec3(0.5f));
  ASSERT_EQ(files.warnings().size(), 1u);
  EXPECT_EQ(files.warnings()[0].find(
                "room.obj: 1 texture cannot be read (first: needed by material 'm', bad.png: "),
            0u)
      << files.all_warnings();
}

TEST(LoadMtl, a_texture_may_emit_where_Ke_is_silent) {
  SceneFiles files;
  write_half_white(files.path("half.png"));
  EXPECT_EQ(load_material(files, "newmtl m\nKd 0 0 0\nmap_Ke half.png\n").emittance, pi * Vec3(0.5f));
  EXPECT_TRUE(files.warnings().empty()) << files.all_warnings();
  EXPECT_EQ(load_material(files, "newmtl m\nKd 0 0 0\nKe 2 2 2\nmap_Ke half.png\n").emittance,
            pi * Vec3(2.0f));
  EXPECT_EQ(files.all_warnings(), "room.obj: map_Ke is passed over where Ke is given, as for 'm'\n");
}

TEST(LoadMtl, a_missing_emissive_texture_emits_nothing) {
  SceneFiles files;
  EXPECT_EQ(load_material(files, "newmtl m\nKd 0 0 0\nmap_Ke gone.png\n").emittance, Vec3(0.0f));
  EXPECT_NE(files.all_warnings().find("gone.png"), std::string::npos) << files.all_warnings();
}

TEST(ReadMtl, steps_over_texture_options) {
  const auto name = [](const std::string& operands) {
    return read_mtl("newmtl m\nmap_Kd " + operands, "x.mtl").at(0).map_kd.name;
  };
  EXPECT_EQ(name("wood.png"), "wood.png");
  EXPECT_EQ(name("  my wood.png  "), "my wood.png");
  EXPECT_EQ(name("-s 1 1 1 -bm 1 file name.png"), "file name.png");
  EXPECT_EQ(name("-s 2 wood.png"), "wood.png");
  EXPECT_EQ(name("-o 0.5 0.5 -clamp on -mm 0 1 -imfchan r wood.png"), "wood.png");
  EXPECT_EQ(name("-type sphere \"quoted name.png\""), "quoted name.png");
  EXPECT_EQ(name("-strange.png"), "-strange.png");
  EXPECT_EQ(name("-s"), "");
}

TEST(ReadMtl, keywords_may_be_written_in_any_case) {
  const auto material = read_mtl("newmtl m\nkd 0.5 0.5 0.5\nMAP_KD a.png\n", "x.mtl").at(0);
  EXPECT_EQ(material.kd, Vec3(0.5f));
  EXPECT_EQ(material.map_kd.name, "a.png");
}

TEST(ReadMtl, what_stands_before_the_first_newmtl_belongs_to_nobody) {
  EXPECT_EQ(read_mtl("Kd 1 1 1\nnewmtl  a b \n", "x.mtl").at(0).name, "a b");
  EXPECT_TRUE(read_mtl("Kd 1 1 1\n", "x.mtl").empty());
}

TEST(Mtllib, a_missing_file_is_told_with_its_line) {
  SceneFiles files;
  const auto scene = files.load_text("\nmtllib gone.mtl\n" + triangle + "usemtl m\nf 1/1 2/2 3/3\n");
  EXPECT_EQ(scene.materials[0].name, "m");
  EXPECT_EQ(scene.materials[0].reflectance, Vec3(0.5f));
  EXPECT_EQ(files.all_warnings(),
            "room.obj:2: the material file 'gone.mtl' was not found beside the OBJ file\n"
            "room.obj:9: no MTL file describes 'm'; a grey of 0.5 is taken\n");
}

TEST(Mtllib, a_name_the_file_lacks_is_told_with_line_and_file) {
  SceneFiles files;
  files.write("room.mtl", "newmtl other\nKd 1 0 0\n");
  const auto scene = files.load_text("mtllib room.mtl\n" + triangle + "usemtl m\nf 1/1 2/2 3/3\n");
  EXPECT_EQ(scene.materials[0].reflectance, Vec3(0.5f));
  EXPECT_EQ(files.all_warnings(), "room.obj:8: 'room.mtl' does not describe 'm'; a grey of 0.5 is taken\n");
}

TEST(Mtllib, several_files_on_one_line_are_all_read) {
  SceneFiles files;
  files.write("a.mtl", "newmtl a\nKd 0.1 0.1 0.1\nnewmtl both\nKd 0.3 0.3 0.3\n");
  files.write("b.mtl", "newmtl b\nKd 0.2 0.2 0.2\nnewmtl both\nKd 0.4 0.4 0.4\n");
  const auto scene =
      files.load_text("mtllib  gone.mtl a.mtl\tb.mtl \n" + triangle +
                      "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 2/2 3/3\nusemtl both\nf 1/1 2/2 3/3\n");
  EXPECT_EQ(scene.materials[0].reflectance, Vec3(0.1f));
  EXPECT_EQ(scene.materials[1].reflectance, Vec3(0.2f));
  EXPECT_EQ(scene.materials[2].reflectance, Vec3(0.3f));  // the first one found counts
  EXPECT_EQ(files.warnings().size(), 1u) << files.all_warnings();
}

TEST(Mtllib, a_file_name_may_hold_blanks) {
  SceneFiles files;
  files.write("my room.mtl", "newmtl m\nKd 0.1 0.1 0.1\n");
  const auto scene = files.load_text("mtllib my room.mtl\n" + triangle + "usemtl m\nf 1/1 2/2 3/3\n");
  EXPECT_EQ(scene.materials[0].reflectance, Vec3(0.1f));
  EXPECT_TRUE(files.warnings().empty()) << files.all_warnings();
}

TEST(Mtllib, may_come_after_the_faces_and_twice) {
  SceneFiles files;
  files.write("room.mtl", "newmtl  m \nKd 0.1 0.1 0.1\n");
  const auto scene =
      files.load_text(triangle + "usemtl  m  \nf 1/1 2/2 3/3\ng x\nmtllib room.mtl\nmtllib room.mtl\n");
  EXPECT_EQ(scene.materials[0].reflectance, Vec3(0.1f));
  EXPECT_TRUE(files.warnings().empty()) << files.all_warnings();
}

TEST(Mtllib, a_file_without_materials_does_no_harm) {
  SceneFiles files;
  files.write("room.mtl", "");
  const auto scene = files.load_text("mtllib room.mtl\n" + triangle + "usemtl m\nf 1/1 2/2 3/3\n");
  EXPECT_EQ(scene.materials[0].reflectance, Vec3(0.5f));
}

TEST(Mtllib, a_binary_file_is_refused) {
  SceneFiles files;
  EXPECT_EQ(refusal(files, std::string("newmtl m\0", 9)),
            "room.mtl:1: expected text, found a zero byte; the file is binary or damaged");
}

TEST(Mtllib, a_folder_of_that_name_is_not_found) {
  SceneFiles files;
  std::filesystem::create_directory(files.path("room.mtl"));
  files.load_text("mtllib room.mtl\n" + triangle + "usemtl m\nf 1/1 2/2 3/3\n");
  EXPECT_EQ(files.warnings().at(0),
            "room.obj:1: the material file 'room.mtl' was not found beside the OBJ file");
}

}  // namespace
}  // namespace luxel
