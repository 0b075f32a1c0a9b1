// SPDX-License-Identifier: Apache-2.0
// A word that one thread writes and others read, with release and acquire semantics: a reader that sees the new value also sees all
// earlier writes of the writer.  C99 has no such operation, but gcc and clang do.  Otherwise (8-bit chips, which have one thread,
// and other compilers) it is a volatile access.
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
