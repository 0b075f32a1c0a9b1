// SPDX-License-Identifier: Apache-2.0
// A counter that several threads increment without a lock.  C99 has no such operation. gcc and clang do, and report whether it
// takes only a few instructions.  Otherwise (8-bit chips, which have one thread, and other compilers) it is an ordinary addition.
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
