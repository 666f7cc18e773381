// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/ending_of.h"
#include "luxel/solution/solution_file.h"

namespace luxel {

bool is_solution(const std::filesystem::path& path) { return ending_of(path) == ".vtkhdf"; }

}  // namespace luxel
