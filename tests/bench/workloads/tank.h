// SPDX-License-Identifier: Apache-2.0
// The tank of the thesis (Figure 2.7), handwritten.
#ifndef BENCH_TANK_H
#define BENCH_TANK_H

#include <stdbool.h>
#include <stdint.h>

#include "tank_o2.h"

typedef struct TankIn {
    uint64_t time;
    double tankPressure;
} TankIn;

typedef struct TankNative {
    uint32_t state;
    bool first;
    uint64_t start;
    uint64_t counter;
} TankNative;

void tank_native_init(TankNative *m, TankSv *sv);
void tank_native_step(TankNative *m, TankSv *sv);

typedef struct TankF64 {
    uint32_t state;
    bool first, ran;
    uint64_t start, last, T;
    uint16_t P_AbortThreshold;
    uint64_t counter;
} TankF64;

void tank_f64_init(TankF64 *m, TankSv *sv);
void tank_f64_step(TankF64 *m, TankSv *sv);

#endif
