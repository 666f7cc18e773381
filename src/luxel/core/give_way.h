// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace luxel {

// From now on the calling thread, and those that it starts, leave the processor to others that want it: a
// tenth of a core is what remains to it beside one of the usual priority, all of it where nobody else works.
// For work in the background of a window. Linux (nice values are those of a thread there); elsewhere nothing
// changes.
void give_way();

}  // namespace luxel
