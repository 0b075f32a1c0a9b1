// SPDX-License-Identifier: Apache-2.0
// The arithmetic, handwritten.
#ifndef BENCH_ARITH_H
#define BENCH_ARITH_H

#include <stdbool.h>
#include <stdint.h>

#include "arith_o2.h"

typedef struct ArithIn {
    uint64_t time;
    double pressure;
    int32_t setpoint, encoder;
    float airspeed;
    int16_t gyroX, gyroY, gyroZ;
    uint16_t adc0, adc1, adc2;
    int8_t trim;
    uint8_t mode, enable;
} ArithIn;

typedef struct ArithNative {
    bool first;
    float drift;
    uint16_t last, bad;
    int32_t before;
} ArithNative;

void arith_native_init(ArithNative *m, ArithSv *sv);
void arith_native_step(ArithNative *m, ArithSv *sv);

typedef struct ArithF64 {
    uint32_t state;
    bool first, ran;
    uint64_t start, before_g, T;
    float drift;
    uint16_t last, bad;
    int32_t before;
} ArithF64;

void arith_f64_init(ArithF64 *m, ArithSv *sv);
void arith_f64_step(ArithF64 *m, ArithSv *sv);

#endif
