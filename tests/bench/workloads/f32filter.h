// SPDX-License-Identifier: Apache-2.0
// The filters, handwritten.
#ifndef BENCH_F32FILTER_H
#define BENCH_F32FILTER_H

#include <stdbool.h>
#include <stdint.h>

#include "f32filter_o2.h"
#include "tests/bench/workloads/frame.h"

typedef struct F32filterIn {
    uint64_t time;
    float accX;
    float accY;
    float accZ;
    float gyroX;
    float gyroY;
    float baro;
    float command;
} F32filterIn;

typedef struct F32filterNative {
    bool first;
    float xa, xb, ya, yb, ua, ub, va, vb, lastWash, lastBand, slowBand, lastLead;
} F32filterNative;

void f32filter_native_init(F32filterNative *m, F32filterSv *sv);
void f32filter_native_step(F32filterNative *m, F32filterSv *sv);

typedef struct F32filterF64 {
    Frame frame;
    float xa, xb, ya, yb, ua, ub, va, vb, lastWash, lastBand, slowBand, lastLead;
} F32filterF64;

void f32filter_f64_init(F32filterF64 *m, F32filterSv *sv);
void f32filter_f64_step(F32filterF64 *m, F32filterSv *sv);

#endif
