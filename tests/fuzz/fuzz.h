// SPDX-License-Identifier: Apache-2.0
// A fuzz target is one function with libFuzzer's name.  It runs under clang's -fsanitize=fuzzer, under afl-fuzz through files, or under driver.c
// with any C compiler.
#ifndef TESTS_FUZZ_H
#define TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "tests/heap.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

// Each target counts the inputs that passed its first checks and reached the tested code.  It defines how many of a hundred inputs must do so.
// driver.c fails below that, because a target that refuses all inputs at once tests nothing.
extern unsigned long fuzz_reached;
extern const unsigned fuzz_floor;

// A condition that must be true for every input.
#define FUZZ_CHECK(condition)                                                                     \
    do {                                                                                          \
        if (!(condition)) {                                                                       \
            fprintf(stderr, "%s:%d: does not hold: %s\n", __FILE__, __LINE__, #condition);        \
            abort();                                                                              \
        }                                                                                         \
    } while (0)

#endif
