// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "luxel/import/apply_spectra.h"

#include "support/scene_files.h"

namespace luxel {
namespace {

const std::string header = "material,quantity,wavelength_nm,value\n";

// A floor of wood under a lamp.
class Spectra : public testing::Test {
 protected:
  Spectra() {
    files_.write("room.obj",
                 "mtllib room.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl wood, \"oiled\"\nf 1 2 3\nusemtl "
                 "lamp\nf 1 3 2\n");
    files_.write("room.mtl", "newmtl wood, \"oiled\"\nKd .4 .3 .2\nd 0.1\nnewmtl lamp\nKd 1 1 1\nKe 5 5 5\n");
  }
  Scene load(const std::string& csv, LoadOptions options = {}) {
    files_.write("room.csv", csv);
    options.spectra = files_.path("room.csv");
    return files_.load("room.obj", options);
  }
  std::string refusal(const std::string& csv, LoadOptions options = {}) {
    files_.write("room.csv", csv);
    options.spectra = files_.path("room.csv");
    return files_.refusal("room.obj", options);
  }
  SceneFiles files_;
};

TEST_F(Spectra, names_in_quotes_comments_and_any_order_of_rows_are_understood) {
  const auto scene = load("\xef\xbb\xbf# measured\r\n" + header +
                          "\r\n\"wood, \"\"oiled\"\"\", reflectance , 700, 0.5\r\n"
                          "lamp,radiance,400,0\n"
                          "\"wood, \"\"oiled\"\"\",reflectance,400,2e-1\n"
                          "lamp,radiance,700,1.5");
  EXPECT_EQ(scene.materials[0].reflectance_spectrum, Spectrum({{400.0, 0.2}, {700.0, 0.5}}));
  EXPECT_TRUE(scene.materials[0].emittance_spectrum.empty());
  ASSERT_EQ(scene.materials[1].emittance_spectrum.samples().size(), 2u);
  EXPECT_FLOAT_EQ(static_cast<float>(scene.materials[1].emittance_spectrum.at(700.0, Beyond::zero)),
                  1.5f * pi);
  EXPECT_NO_THROW(check_scene(scene));
}

TEST_F(Spectra, wavelengths_are_those_of_the_file_and_even_steps_between) {
  const auto scene = load(header +
                          "lamp,reflectance,400,0\nlamp,reflectance,404,0\nlamp,reflectance,425,0\n"
                          "lamp,radiance,350,1\nlamp,radiance,700,1\nlamp,radiance,2000,1\n");
  const auto& w = scene.wavelengths;
  ASSERT_GE(w.size(), 6u);
  EXPECT_EQ((std::vector<double>{w.begin(), w.begin() + 6}),
            (std::vector<double>{400.0, 404.0, 411.0, 418.0, 425.0, 425.0 + 275.0 / 28.0}));
  EXPECT_EQ(w.back(), 700.0);
  EXPECT_EQ(w.size(), 5u + 28u);
  EXPECT_FALSE(scene.averages_spectra);
}

TEST_F(Spectra, as_many_bands_as_asked_for_lie_even_steps_apart) {
  const auto scene = load(header + "lamp,radiance,400,1\nlamp,radiance,700,1\n", {.bands = 31});
  ASSERT_EQ(scene.wavelengths.size(), 31u);
  for (std::size_t i = 0; i < 31; ++i)
    EXPECT_NEAR(scene.wavelengths[i], 400.0 + 10.0 * static_cast<double>(i), 1e-9);
  EXPECT_TRUE(scene.averages_spectra);
}

TEST_F(Spectra, a_measured_lamp_shines_where_the_material_had_no_light) {
  EXPECT_FALSE(load(header + "lamp,reflectance,400,0\nlamp,reflectance,700,0\n").materials[0].opaque);
  const auto scene =
      load(header + "\"wood, \"\"oiled\"\"\",radiance,400,1\n\"wood, \"\"oiled\"\"\",radiance,700,1\n");
  EXPECT_TRUE(scene.materials[0].is_lamp());
  EXPECT_TRUE(scene.materials[0].opaque);
  EXPECT_FALSE(load(header + "lamp,radiance,400,0\nlamp,radiance,700,0\n").materials[1].is_lamp());
}

TEST_F(Spectra, reflectances_are_lowered_to_the_greatest_with_a_warning) {
  const auto scene = load(header + "lamp,reflectance,400,1\nlamp,reflectance,700,0.5\n");
  EXPECT_FLOAT_EQ(static_cast<float>(scene.materials[1].reflectance_spectrum.front().value), 0.98f);
  EXPECT_NE(files_.warnings().back().find("'lamp'"), std::string::npos);
}

TEST_F(Spectra, the_sky_is_measured_too) {
  const auto csv = header + ",sky,400,1\n,sky,700,2\n";
  EXPECT_EQ(load(csv).sky_spectrum.back().value, 2.0);
  EXPECT_EQ(refusal(csv, {.sky = Vec3(1.0f)}),
            "room.csv:2: the sky is given twice: leave one of the two away");
}

TEST_F(Spectra, other_spectra_are_another_scene) {
  const auto one = load(header + "lamp,radiance,400,1\nlamp,radiance,700,1\n");
  const auto other = load(header + "lamp,radiance,400,1\nlamp,radiance,700,1.5\n");
  const auto coarse = load(header + "lamp,radiance,400,1\nlamp,radiance,700,1\n", {.bands = 9});
  EXPECT_NE(fingerprint(one), fingerprint(files_.load("room.obj")));
  EXPECT_NE(fingerprint(one), fingerprint(other));
  EXPECT_NE(fingerprint(one), fingerprint(coarse));
}

TEST_F(Spectra, what_is_damaged_is_one_sentence_with_its_line) {
  const auto rows = [](const std::string& text) { return header + "# a comment\n" + text; };
  const auto expect = [&](const std::string& csv, const std::string& sentence) {
    EXPECT_EQ(refusal(csv), "room.csv:" + sentence);
  };
  expect("", "1: expected the line 'material,quantity,wavelength_nm,value', found nothing");
  expect("lamp,radiance,400,1\n",
         "1: expected the line 'material,quantity,wavelength_nm,value', found 'lamp,radiance,400,1'");
  expect(header, " expected at least one spectrum, found none");
  expect(rows("lamp,radiance,400\n"),
         "3: expected 4 fields (material,quantity,wavelength_nm,value), found 3");
  expect(rows("lamp,radiance,400,1,\n"),
         "3: expected 4 fields (material,quantity,wavelength_nm,value), found 5");
  expect(rows("lamp,colour,400,1\n"),
         "3: expected the quantity reflectance, radiance or sky, found 'colour'");
  expect(rows(",radiance,400,1\n"), "3: expected the name of a material, found none");
  expect(rows("lamp,sky,400,1\n"), "3: expected no material for the sky, found 'lamp'");
  expect(rows("\"lamp,radiance,400,1\n"), "3: a double quote is not closed");
  expect(rows("\"lamp\" x,radiance,400,1\n"),
         "3: expected ',' after a closing quote, found 'x,radiance,400,1'");
  expect(rows("lamp,radiance,0.4,1\n"), "3: expected a wavelength from 1 to 1e+06 nm, found '0.4'");
  expect(rows("lamp,radiance,nan,1\n"), "3: expected a wavelength from 1 to 1e+06 nm, found 'nan'");
  expect(rows("lamp,reflectance,400,1.2\n"), "3: expected a reflectance from 0 to 1, found '1.2'");
  expect(rows("lamp,radiance,400,-1\n"), "3: expected a radiance from 0 to 1e+12 W/(m² sr nm), found '-1'");
  expect(rows("lamp,radiance,400,\n"), "3: expected a radiance from 0 to 1e+12 W/(m² sr nm), found ''");
  expect(rows("lamp,radiance,400,1\nlamp,reflectance,400,1\nlamp,radiance,400,2\n"),
         "5: expected one value a wavelength, found 400 nm again (first on line 3)");
  expect(rows("lamp,radiance,400,1\n"), "3: expected a radiance at two wavelengths or more, found one");
  expect(rows("lamp,radiance,500,1\nlamp,radiance,700,1\n"),
         " expected wavelengths that reach from 420 to 680 nm or beyond, as colours need them, found 500 to "
         "700 nm");
  expect(rows("lamp,radiance,900,1\nlamp,radiance,1000,1\n"),
         " expected wavelengths that reach from 420 to 680 nm or beyond, as colours need them, found none "
         "that an "
         "eye sees");
  EXPECT_NE(refusal(rows("lamp,radiance,400,1\nlamp,radiance,700,1\nsteel,reflectance,400,1\n"))
                .find("which has 'wood, \"oiled\"', 'lamp', found 'steel'"),
            std::string::npos);
  std::string many = header;
  for (int i = 0; i <= 600; ++i) many += "lamp,radiance," + std::to_string(400.0 + 0.5 * i) + ",1\n";
  EXPECT_NE(refusal(many).find("601 different wavelengths, more than 500"), std::string::npos);
  EXPECT_EQ(load(many, {.bands = 500}).wavelengths.size(), 500u);
}

}  // namespace
}  // namespace luxel
