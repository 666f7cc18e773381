// SPDX-License-Identifier: Apache-2.0
#include "luxel/core/give_way.h"

#ifdef __linux__
#include <sys/resource.h>
#endif

namespace luxel {

void give_way() {
#ifdef __linux__
  constexpr int nicer = 10;
  // 0 is the calling thread. Raising the niceness is always permitted; beyond its maximum it is clamped.
  setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + nicer);
#endif
}

}  // namespace luxel
