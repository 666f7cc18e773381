// SPDX-License-Identifier: Apache-2.0
// write_sample_solution FILE PATCHES BANDS [errors]: the sample of sample_solution.h as a file, for readers
// that are not ours; with its standard errors or without. tests/golden/solution-v1.vtkhdf is what it wrote
// for 4 patches and 3 bands at format version 1.
#include <cstdio>
#include <exception>
#include <string>

#include "support/sample_solution.h"

int main(int argc, char** argv) try {
  if (argc != 4 && argc != 5) {
    std::fprintf(stderr, "usage: write_sample_solution FILE PATCHES BANDS [errors]\n");
    return 2;
  }
  const auto make = argc == 5 ? luxel::sample::baked_with_errors : luxel::sample::baked;
  const auto sample = make(std::stoul(argv[2]), std::stoul(argv[3]));
  luxel::write_solution(argv[1], sample.patches, sample.solution);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
