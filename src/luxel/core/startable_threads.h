// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

// How many threads, the calling one included, this process can run: `wanted`, or fewer where a limit (of
// processes, memory or a container) prevents it. TBB does not return where a thread of its own cannot be
// started, so that many are started here at the same time, and ended, at the first call; once some failed,
// no later call gives more. Cost of the first call: about 30 us per thread. Thread-safe.
int startable_threads(int wanted);

}  // namespace luxel
