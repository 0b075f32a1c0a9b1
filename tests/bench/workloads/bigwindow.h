// SPDX-License-Identifier: Apache-2.0
// The large window, handwritten.
#ifndef BENCH_BIGWINDOW_H
#define BENCH_BIGWINDOW_H

#include <stdbool.h>
#include <stdint.h>

#include "bigwindow_o2.h"

typedef struct BigwindowIn {
    uint64_t time;
    double pressure;
} BigwindowIn;

enum { WINDOW_OF = 1001 };

typedef struct BigwindowNative {
    bool first;
    unsigned n, next;
    double sample[WINDOW_OF], sorted[WINDOW_OF];
} BigwindowNative;

void bigwindow_native_init(BigwindowNative *m, BigwindowSv *sv);
void bigwindow_native_step(BigwindowNative *m, BigwindowSv *sv);

typedef struct BigwindowF64 {
    uint32_t state;
    bool first, ran;
    uint64_t start, last, T;
    uint32_t n, next;
    double slot[WINDOW_OF], sorted[WINDOW_OF];
} BigwindowF64;

void bigwindow_f64_init(BigwindowF64 *m, BigwindowSv *sv);
void bigwindow_f64_step(BigwindowF64 *m, BigwindowSv *sv);

#endif
