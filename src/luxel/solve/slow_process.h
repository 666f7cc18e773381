// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace luxel {

// A process that all others waited for.
struct SlowProcess {
  std::size_t process = 0;
  double seconds = 0.0;  // that each of the others waited longer than it, at least
};

// waits: [process], s spent in waiting for the others; seconds: of the whole work. Nothing where no process
// held up the others for a second and a twentieth of the work.
std::optional<SlowProcess> slow_process(std::span<const double> waits, double seconds);

}  // namespace luxel
