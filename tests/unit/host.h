// SPDX-License-Identifier: Apache-2.0
// An arena for unit tests, on the C library's heap.
#ifndef SM_TEST_HOST_H
#define SM_TEST_HOST_H

#include <stdio.h>
#include <stdlib.h>

#include "compiler/base/arena.h"
#include "tests/heap.h"

static jmp_buf host_oom;

// Running out of memory ends a test with a failure.
static inline void host_check(int code)
{
    if (code) {
        puts("out of memory: 0 passed, 1 failed");
        exit(1);
    }
}

#define HOST_ARENA(a) (host_check(setjmp(host_oom)), arena_init((a), heap_alloc, NULL, &host_oom))

#endif
