// SPDX-License-Identifier: Apache-2.0
// write_sample_solution FILE PATCHES BANDS [errors|far]: the sample of sample_solution.h as a file, for
// readers that are not ours; plain, with its standard errors or far from zero.
// tests/golden/solution-v1.vtkhdf is its output for 4 patches and 3 bands at format version 1.
#include <cstdio>
#include <exception>
#include <string>

#include "support/sample_solution.h"

int main(int argc, char** argv) try {
  if (argc != 4 && argc != 5) {
    std::fprintf(stderr, "usage: write_sample_solution FILE PATCHES BANDS [errors|far]\n");
    return 2;
  }
  const std::string kind = argc == 5 ? argv[4] : "";
  const auto make = kind == "errors" ? luxel::sample::baked_with_errors
                    : kind == "far"  ? luxel::sample::baked_far_away
                                     : luxel::sample::baked;
  const auto sample = make(std::stoul(argv[2]), std::stoul(argv[3]));
  luxel::write_solution(argv[1], sample.patches, sample.solution);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
