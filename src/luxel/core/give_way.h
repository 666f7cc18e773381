// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

// Lowers the priority of the calling thread, and of those that it starts, for background work of a window.
// Beside a thread of the usual priority it gets a tenth of a core; on an idle core it gets all of it. Linux
// (nice values are per thread there); has no effect elsewhere.
void give_way();

}  // namespace luxel
