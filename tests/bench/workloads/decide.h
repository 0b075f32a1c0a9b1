// SPDX-License-Identifier: Apache-2.0
// The decisions, handwritten.
#ifndef BENCH_DECIDE_H
#define BENCH_DECIDE_H

#include <stdbool.h>
#include <stdint.h>

#include "decide_o2.h"
#include "tests/bench/workloads/frame.h"

typedef struct DecideIn {
    uint64_t time;
    double chamber;
    float lox;
    float fuel;
    float flow;
    int32_t thrust;
    uint16_t bus;
    uint16_t speed;
    int16_t vibe;
    int16_t temp;
    uint8_t mode;
    uint8_t command;
    uint8_t armed;
    uint8_t hot;
    uint8_t cold;
    uint8_t wet;
} DecideIn;

typedef struct DecideNative { bool first; } DecideNative;

void decide_native_init(DecideNative *m, DecideSv *sv);
void decide_native_step(DecideNative *m, DecideSv *sv);

typedef struct DecideF64 { Frame frame; } DecideF64;

void decide_f64_init(DecideF64 *m, DecideSv *sv);
void decide_f64_step(DecideF64 *m, DecideSv *sv);

#endif
