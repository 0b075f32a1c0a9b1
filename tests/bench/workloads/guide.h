// SPDX-License-Identifier: Apache-2.0
// The glider, handwritten.
#ifndef BENCH_GUIDE_H
#define BENCH_GUIDE_H

#include <stdbool.h>
#include <stdint.h>

#include "guide_o2.h"
#include "tests/bench/workloads/frame.h"

typedef struct GuideIn {
    uint64_t time;
    float gyroP;
    float gyroQ;
    float gyroR;
    float airspeed;
    float windNorth;
    float windEast;
    float padLat;
    float padLon;
} GuideIn;

typedef struct GuideNative {
    uint32_t state;
    bool first;
    uint64_t start;
} GuideNative;

void guide_native_init(GuideNative *m, GuideSv *sv);
void guide_native_step(GuideNative *m, GuideSv *sv);

typedef struct GuideF64 {
    Frame frame;
    double north, east, sr, cr, h, error;
} GuideF64;

void guide_f64_init(GuideF64 *m, GuideSv *sv);
void guide_f64_step(GuideF64 *m, GuideSv *sv);

#endif
