// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

// Returns the number of threads, the calling one included, that this process can run: `wanted`, or fewer
// where a limit (of processes, memory or a container) prevents it. TBB hangs where it cannot start a thread;
// therefore that many are started here at the same time, and ended, at the first call; once some failed, no
// later call gives more. Cost of the first call: about 30 us per thread. Thread-safe.
int startable_threads(int wanted);

}  // namespace luxel
