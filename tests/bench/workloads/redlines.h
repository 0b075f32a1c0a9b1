// SPDX-License-Identifier: Apache-2.0
// The red lines, handwritten.
#ifndef BENCH_REDLINES_H
#define BENCH_REDLINES_H

#include <stdbool.h>
#include <stdint.h>

#include "redlines_o2.h"
#include "tests/bench/workloads/frame.h"
#include "tests/bench/workloads/window.h"

enum { SENSORS = 24, AVERAGED = 4 };

typedef struct RedlinesIn {
    uint64_t time;
    float sensor[SENSORS];
    uint8_t reset;
} RedlinesIn;

typedef struct RedlinesNative {
    uint32_t state;
    bool first;
    uint64_t start;
    uint32_t n;                        // number of samples taken
    float sample[4][SENSORS];          // sample i is in sample[i % 4]
} RedlinesNative;

void redlines_native_init(RedlinesNative *m, RedlinesSv *sv);
void redlines_native_step(RedlinesNative *m, RedlinesSv *sv);

typedef struct RedlinesF64 {
    Frame frame;
    Window median[SENSORS], average[AVERAGED];
    double three[SENSORS][3], four[AVERAGED][4];
} RedlinesF64;

void redlines_f64_init(RedlinesF64 *m, RedlinesSv *sv);
void redlines_f64_step(RedlinesF64 *m, RedlinesSv *sv);

#endif
