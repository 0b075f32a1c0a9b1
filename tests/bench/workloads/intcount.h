// SPDX-License-Identifier: Apache-2.0
// The counters, handwritten.
#ifndef BENCH_INTCOUNT_H
#define BENCH_INTCOUNT_H

#include <stdbool.h>
#include <stdint.h>

#include "intcount_o2.h"
#include "tests/bench/workloads/frame.h"

typedef struct IntcountIn {
    uint64_t time;
    int32_t encoder;
    uint16_t adc0;
    uint16_t adc1;
    int16_t gyro;
    int8_t trim;
    uint8_t mode;
    uint8_t pulse;
    uint8_t fault;
} IntcountIn;

typedef struct IntcountNative { bool first; uint8_t tenths; uint16_t last; int32_t before; } IntcountNative;

void intcount_native_init(IntcountNative *m, IntcountSv *sv);
void intcount_native_step(IntcountNative *m, IntcountSv *sv);

typedef struct IntcountF64 { Frame frame; uint8_t tenths; uint16_t last; int32_t before; } IntcountF64;

void intcount_f64_init(IntcountF64 *m, IntcountSv *sv);
void intcount_f64_step(IntcountF64 *m, IntcountSv *sv);

#endif
