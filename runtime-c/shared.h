// SPDX-License-Identifier: Apache-2.0
// A word that one thread writes and others read.  What was written before the word can be seen by whoever has read it.  C99 has nothing
// for it; gcc and clang have.  Elsewhere (8-bit chips, which have one thread, and other compilers) it is a volatile access.
#ifndef SM_SHARED_H
#define SM_SHARED_H

#include <stdint.h>

#if defined(__GCC_ATOMIC_INT_LOCK_FREE) && __GCC_ATOMIC_INT_LOCK_FREE == 2 && __SIZEOF_INT__ == 4
static inline uint32_t sm_shared_read(const uint32_t *word) { return __atomic_load_n(word, __ATOMIC_ACQUIRE); }
static inline void sm_shared_write(uint32_t *word, uint32_t value) { __atomic_store_n(word, value, __ATOMIC_RELEASE); }
#else
static inline uint32_t sm_shared_read(const uint32_t *word) { return *(const volatile uint32_t *)word; }
static inline void sm_shared_write(uint32_t *word, uint32_t value) { *(volatile uint32_t *)word = value; }
#endif

#endif
