// SPDX-License-Identifier: Apache-2.0
// write_sample_solution FILE PATCHES BANDS: the sample of sample_solution.h as a file, for readers that are
// not ours. tests/golden/solution-v1.vtkhdf is what it wrote for 4 patches and 3 bands at format version 1.
#include <cstdio>
#include <exception>
#include <string>

#include "support/sample_solution.h"

int main(int argc, char** argv) try {
  if (argc != 4) {
    std::fprintf(stderr, "usage: write_sample_solution FILE PATCHES BANDS\n");
    return 2;
  }
  const auto sample = luxel::sample::baked(std::stoul(argv[2]), std::stoul(argv[3]));
  luxel::write_solution(argv[1], sample.patches, sample.solution);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
