// SPDX-License-Identifier: Apache-2.0
// Reads a solution file and prints, for each material, its area and the mean irradiance of its fronts.
//
//     read_solution box.vtkhdf
#include <cstdio>
#include <vector>

#include <luxel/core/error.h>
#include <luxel/solution/solution_file.h>
#include <luxel/version.h>

int main(int count, char** arguments) try {
  if (count != 2) throw luxel::InputError("read_solution: expected one solution file, .vtkhdf");
  const auto baked = luxel::read_solution(arguments[1]);
  const auto& patches = baked.patches;
  const auto& light = baked.solution;
  const auto& made = light.provenance;
  std::printf("method %s, %zu patches, %llu rays, error %.4f, written by Luxel %s, read by %s\n",
              made.method.c_str(), patches.size(), static_cast<unsigned long long>(made.rays),
              light.seen_error, made.program_version.c_str(), LUXEL_VERSION);

  // Arrays are [patch][band], flat; a sum over patches is a double.
  const auto bands = patches.band_count();
  std::vector<double> area(patches.materials.size(), 0.0), power(patches.materials.size() * bands, 0.0);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto m = static_cast<std::size_t>(patches.material[p]);
    const auto patch_area = static_cast<double>(patches.area[p]);  // m²
    area[m] += patch_area;
    for (std::size_t b = 0; b < bands; ++b)
      power[m * bands + b] += patch_area * static_cast<double>(light.irradiance.front[p * bands + b]);  // W
  }
  for (std::size_t m = 0; m < area.size(); ++m) {
    std::printf("%s: %.4f m2,", patches.materials[m].name.c_str(), area[m]);
    for (std::size_t b = 0; b < bands; ++b)
      std::printf(" %s %.4f", patches.bands[b].c_str(), area[m] > 0.0 ? power[m * bands + b] / area[m] : 0.0);
    std::printf(" W/m2\n");
  }
} catch (const luxel::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
