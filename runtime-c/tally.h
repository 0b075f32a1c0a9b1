// SPDX-License-Identifier: Apache-2.0
// A count that several threads raise without a lock.  C99 has nothing for it; gcc and clang have, and say where it is one instruction or
// a few.  Elsewhere (8-bit chips, which have one thread, and other compilers) it is an ordinary addition.
#ifndef SM_TALLY_H
#define SM_TALLY_H

#include <stdint.h>

static inline void sm_tally(uint32_t *count)
{
#if defined(__GCC_ATOMIC_INT_LOCK_FREE) && defined(__GCC_ATOMIC_LONG_LOCK_FREE) && __GCC_ATOMIC_INT_LOCK_FREE == 2 && \
    __GCC_ATOMIC_LONG_LOCK_FREE == 2
    __atomic_fetch_add(count, 1u, __ATOMIC_RELAXED);
#else
    ++*count;
#endif
}

#endif
