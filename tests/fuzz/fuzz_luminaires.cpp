// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "luxel/import/luminaires.h"

#include "fuzz/answered.h"
#include "fuzz/scratch_file.h"

namespace luxel {
namespace {

void expect_sound_placement(const LuminairePlacement& placement) {
  expect(placement.photometry != nullptr);
  expect(std::isfinite(placement.position.x + placement.position.y + placement.position.z));
  expect(placement.dimming >= 0.0 && std::isfinite(placement.dimming));
  expect(placement.maintenance > 0.0 && placement.maintenance <= 1.0);
  expect(placement.columns >= 1 && placement.rows >= 1);
}

}  // namespace
}  // namespace luxel

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const luxel::ScratchFile list("list.csv"), lamp("lamp.ies");
  [[maybe_unused]] static const auto written = lamp.filled_with(
      "IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 3 1 1 2 0.1 0.1 0\n1 1 10\n0 45 90\n0\n100 70 0\n");
  return luxel::answered(data, size, [](std::string_view bytes) {
    const luxel::Context context;
    luxel::PhotometryStore store(context);
    for (const auto& placement : luxel::read_luminaires(list.filled_with(bytes), {0, 0, 1}, store))
      luxel::expect_sound_placement(placement);
  });
}
