// SPDX-License-Identifier: Apache-2.0
// The heap of test programs, as arenas want it (compiler/base/arena.h).
#ifndef SM_TEST_HEAP_H
#define SM_TEST_HEAP_H

#include <stdlib.h>

static inline void *heap_alloc(void *context, void *old, size_t size)
{
    (void)context;
    if (size)
        return realloc(old, size);
    free(old);
    return NULL;
}

#endif
