// SPDX-License-Identifier: Apache-2.0
// A fuzz target is one function under libFuzzer's name, so that clang's -fsanitize=fuzzer can drive it.  driver.c drives it
// with nothing but a C compiler, and afl-fuzz through its files.
#ifndef TESTS_FUZZ_H
#define TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

// Each target counts the inputs that passed its first checks and reached the tested code, and defines how many of a hundred must.
// driver.c fails below that: a target whose inputs are all refused at once tests nothing.
extern unsigned long fuzz_reached;
extern const unsigned fuzz_floor;

// What must hold whatever the input is.
#define FUZZ_CHECK(condition)                                                                     \
    do {                                                                                          \
        if (!(condition)) {                                                                       \
            fprintf(stderr, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition);        \
            abort();                                                                              \
        }                                                                                         \
    } while (0)

static inline void *fuzz_alloc(void *context, void *old, size_t size)
{
    (void)context;
    if (size)
        return realloc(old, size);
    free(old);
    return NULL;
}

#endif
