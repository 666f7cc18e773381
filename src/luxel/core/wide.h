// SPDX-License-Identifier: Apache-2.0
#pragma once

// Eight floats at a time where the processor can: float operations are exact to the last bit whatever their
// width, as long as no sum is reordered, so every host gets the same. For functions of plain loops; the
// functions that they call must be inlined (LUXEL_INLINE), or they are not vectorised.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define LUXEL_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define LUXEL_WIDE
#endif
#define LUXEL_INLINE inline __attribute__((always_inline))
