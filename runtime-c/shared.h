// SPDX-License-Identifier: Apache-2.0
// Words that several threads access without a lock.  C99 has no atomic operations.  gcc and clang have them, and define
// __GCC_ATOMIC_INT_LOCK_FREE as 2 if they need no library.  On 8-bit chips, which have one thread, and with other compilers, these
// functions are ordinary accesses.
#ifndef SM_SHARED_H
#define SM_SHARED_H

#include <stdint.h>

// A word that one thread writes and others read, with release and acquire semantics: a reader that sees the new value also sees
// all earlier writes of the writer.
#if defined(__GCC_ATOMIC_INT_LOCK_FREE) && __GCC_ATOMIC_INT_LOCK_FREE == 2 && __SIZEOF_INT__ == 4
static inline uint32_t sm_shared_read(const uint32_t *word) { return __atomic_load_n(word, __ATOMIC_ACQUIRE); }
static inline void sm_shared_write(uint32_t *word, uint32_t value) { __atomic_store_n(word, value, __ATOMIC_RELEASE); }
#else
static inline uint32_t sm_shared_read(const uint32_t *word) { return *(const volatile uint32_t *)word; }
static inline void sm_shared_write(uint32_t *word, uint32_t value) { *(volatile uint32_t *)word = value; }
#endif

// A counter that several threads increment.
static inline void sm_shared_increment(uint32_t *count)
{
#if defined(__GCC_ATOMIC_INT_LOCK_FREE) && defined(__GCC_ATOMIC_LONG_LOCK_FREE) && __GCC_ATOMIC_INT_LOCK_FREE == 2 && \
    __GCC_ATOMIC_LONG_LOCK_FREE == 2
    __atomic_fetch_add(count, 1u, __ATOMIC_RELAXED);
#else
    ++*count;
#endif
}

#endif
