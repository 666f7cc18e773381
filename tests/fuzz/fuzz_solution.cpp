// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "luxel/solution/solution_file.h"

#include "fuzz/answered.h"
#include "fuzz/scratch_file.h"

namespace luxel {
namespace {

// A solution that was read has patches with an area and, on both sides in every band, finite light.
void expect_sound_solution(const Baked& baked) {
  for (const auto area : baked.patches.area) expect(area > 0.0f && std::isfinite(area));
  const auto values = baked.patches.size() * baked.patches.band_count();
  for (const auto* light : {&baked.solution.irradiance, &baked.solution.radiosity})
    for (const auto* side : {&light->front, &light->back}) {
      expect(side->size() == values);
      for (const auto value : *side) expect(std::isfinite(value));
    }
}

}  // namespace
}  // namespace luxel

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const luxel::ScratchFile file("light.vtkhdf");
  return luxel::answered<luxel::Error>(data, size, [](std::string_view bytes) {
    luxel::expect_sound_solution(luxel::read_solution(file.filled_with(bytes)));
  });
}
