// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "luxel/lighting/areas.h"

#include "fuzz/answered.h"

namespace luxel {
namespace {

// An area that was read has one shape, and maintenance that is a factor.
void expect_sound_area(const CalculationArea& area) {
  expect((area.polygon.empty() ? 0 : 1) + (area.surface.empty() ? 0 : 1) + (area.line.empty() ? 0 : 1) == 1);
  expect(area.polygon.empty() || area.polygon.size() >= 3);
  for (const auto& corner : area.polygon) expect(std::isfinite(corner.x + corner.y + corner.z));
  expect(area.line.empty() || area.line.size() == 2);
  expect(area.border >= 0.0 && (!area.spacing || *area.spacing > 0.0));
  expect(area.maintenance.factor > 0.0 && area.maintenance.factor <= 1.0);
  if (area.normal) expect(std::abs(glm::length(*area.normal) - 1.0) < 1e-9);
}

}  // namespace
}  // namespace luxel

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return luxel::answered(data, size, [](std::string_view bytes) {
    const auto file = luxel::parse_toml(bytes, "nowhere/areas.toml");
    luxel::RequirementTable requirements;
    requirements.add(file);
    luxel::maintenance_of(file);
    for (const luxel::Vec3d up : {luxel::Vec3d(0, 0, 1), luxel::Vec3d(0, 1, 0)})
      for (const auto& area : luxel::areas_of(file, requirements, up)) luxel::expect_sound_area(area);
  });
}
