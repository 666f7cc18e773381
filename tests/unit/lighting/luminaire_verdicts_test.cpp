// SPDX-License-Identifier: Apache-2.0
// Colour rendering and maintenance factors of luminaires.
#include <memory>
#include <tuple>

#include <gtest/gtest.h>

#include "luxel/lighting/colour_rendering.h"
#include "luxel/lighting/maintenance.h"

namespace luxel {
namespace {

PatchSet with_luminaires(const std::vector<std::pair<std::string, float>>& luminaires) {
  PatchSet patches;
  for (const auto& [Ra, maintenance] : luminaires) {
    Photometry photometry;
    photometry.file = "folder/panel.ldt";
    photometry.lamps.emplace_back();
    photometry.lamps[0].colour_rendering = Ra;
    BandPointLight lamp;
    lamp.light.kind = PointLightKind::luminaire;
    lamp.light.photometry = std::make_shared<const Photometry>(photometry);
    lamp.light.maintenance = maintenance;
    patches.point_lights.push_back(lamp);
  }
  return patches;
}

MaintenanceFactor factor(double value) {
  MaintenanceFactor m;
  m.factor = value;
  return m;
}

TEST(ColourRendering, is_read_in_all_forms_of_files) {
  for (const auto& [text, low, high] :
       std::vector<std::tuple<std::string, double, double>>{{"80", 80, 80},
                                                            {"Ra 85", 85, 85},
                                                            {"CRI>90", 90, 90},
                                                            {"> 80", 80, 80},
                                                            {"Ra>=80", 80, 80},
                                                            {"1B", 80, 89},
                                                            {"1A", 90, 100},
                                                            {"1b/80", 80, 89},
                                                            {"2a", 70, 79},
                                                            {"3", 40, 59},
                                                            {"840", 80, 89},
                                                            {"80-89", 80, 80}}) {
    const auto Ra = colour_rendering_of(text);
    ASSERT_TRUE(Ra) << text;
    EXPECT_EQ(Ra->low, low) << text;
    EXPECT_EQ(Ra->high, high) << text;
  }
  for (const auto* text : {"", "LED", "4000 K", "1", "Ra", "-", "good"})
    EXPECT_FALSE(colour_rendering_of(text)) << text;
}

TEST(ColourRendering, is_judged_by_the_least_luminaire) {
  EXPECT_EQ(judge_colour_rendering(with_luminaires({{"1B", 1.0f}, {"1A", 1.0f}}), 80).compliance,
            Compliance::met);
  EXPECT_EQ(judge_colour_rendering(with_luminaires({{"1A", 1.0f}, {"70", 1.0f}}), 80).compliance,
            Compliance::not_met);
  const auto silent = judge_colour_rendering(with_luminaires({{"90", 1.0f}, {"", 1.0f}}), 80);
  EXPECT_EQ(silent.compliance, Compliance::not_known);
  EXPECT_EQ(silent.note, "the file panel.ldt does not state it");
  EXPECT_EQ(judge_colour_rendering(with_luminaires({{"70", 1.0f}, {"", 1.0f}}), 80).compliance,
            Compliance::not_met);
  // 1B is 80 to 89, which does not decide about 85.
  EXPECT_EQ(judge_colour_rendering(with_luminaires({{"1B", 1.0f}}), 85).compliance, Compliance::not_known);
  EXPECT_EQ(judge_colour_rendering({}, 80).compliance, Compliance::not_known);
}

TEST(Maintenance, is_that_of_luminaires_times_that_of_the_area) {
  EXPECT_TRUE(luminaire_maintenance({}).is_initial());
  const AppliedMaintenance none{luminaire_maintenance(with_luminaires({{"", 1.0f}})), {}};
  EXPECT_EQ(none.text(), "initial");
  EXPECT_EQ(maintenance_warning(none, "desk"), "");
  const AppliedMaintenance area{{}, factor(0.8)};
  EXPECT_EQ(area.text(), "maintenance factor 0.80");
  const AppliedMaintenance luminaires{luminaire_maintenance(with_luminaires({{"", 0.8f}, {"", 0.8f}})), {}};
  EXPECT_EQ(luminaires.text(), "maintenance factor of the luminaires 0.80");
  EXPECT_EQ(luminaires.factor(), 0.8);
  const AppliedMaintenance twice{luminaires.luminaires, factor(0.75)};
  EXPECT_NEAR(twice.factor().value_or(0.0), 0.6, 1e-9);
  EXPECT_EQ(twice.text(), "maintenance factor 0.60 (luminaires 0.80, area 0.75)");
  EXPECT_NE(maintenance_warning(twice, "desk")
                .find("luminaires have the factor 0.80, and the area \"desk\" has 0.75"),
            std::string::npos);
  const AppliedMaintenance mixed{luminaire_maintenance(with_luminaires({{"", 0.7f}, {"", 0.9f}})), {}};
  EXPECT_FALSE(mixed.factor());
  EXPECT_EQ(mixed.text(), "maintenance factor of the luminaires 0.70 to 0.90");
  EXPECT_EQ(text_of(MaintenanceFactor{0.804, 0.93, 1.0, 0.92, 0.94}),
            "0.80 (LLMF 0.93, LSF 1, LMF 0.92, RMF 0.94)");
}

}  // namespace
}  // namespace luxel
